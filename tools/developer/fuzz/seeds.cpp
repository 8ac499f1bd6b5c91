/// Writes small files of every format, which the fuzzers start from: `fuzz_seeds FOLDER` makes FOLDER/msh, FOLDER/obj,
/// ...

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kCorners = "element face 2\nproperty list uchar int vertex_indices\nend_header\n";

template <class Number>
std::string raw(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string ply_binary() {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 4\n" + kXyz +
                      "property double nx\nproperty uchar ny\nproperty short nz\n" + kCorners;
  for (int i = 0; i < 4; ++i)
    bytes += raw(float(i)) + raw(.5f) + raw(float(i * i)) + raw(0.) + "\1" + raw(std::int16_t{1});
  return bytes + "\4" + raw(0) + raw(1) + raw(2) + raw(3) + "\3" + raw(0) + raw(1) + raw(2);
}

std::string off_binary() {
  std::string bytes = "NOFF BINARY\n" + raw(3u) + raw(2u) + raw(0u);
  for (int i = 0; i < 18; ++i) bytes += raw(float(i));
  for (int face = 0; face < 2; ++face) bytes += raw(3u) + raw(0u) + raw(1u) + raw(2u);
  return bytes;
}

std::string stl_binary() {
  std::string bytes = std::string(80, ' ') + raw(2u);
  for (int i = 0; i < 24; ++i) bytes += raw(float(i * i)) + (i % 12 == 11 ? raw(std::uint16_t{0}) : "");
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::remove_all(folder);  // a fuzzer adds what it found, and its next run is to be the same
  int files = 0;
  const auto write = [&](const std::string& format, const std::string& name, const std::string& bytes) {
    std::filesystem::create_directories(folder / format);
    std::ofstream(folder / format / name, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    ++files;
  };
  write("msh", "square",
        "4\n2\nvertices\n0\n0\n0\n1\n0\n0\n1\n1\n0\n0\n1\n0."
        "5\ntriangles\n0\n1\n2\n0\n2\n3\nnormals\n0\n0\n1\n0\n0\n1\n0\n0\n"
        "1\n0\n0\n1\ntexcoords\n0\n0\n1\n0\n1\n1\n0\n1\n");
  write("msh", "empty", "0\r\n0\r\nvertices\r\ntriangles\r\n");
  write(
      "obj", "faces",
      "mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\nusemtl a\nf 1/1/1 2/2/1 "
      "3/1/2\nf 1/1/2 3/2/2 4/1/1\nf -4/-1/-1 -3/-1/-1 -2/-2/-2 -1/-1/-1\n");
  write("obj", "plain", "# a comment\r\no a\r\nv 0 0 0 1\r\nv 1 0 0 1\r\nv 1 1 0 1\r\nf 1 2 3\r\n");
  write("obj", "normals", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//2\nf 3//1 2//2 1//1\n");
  write("ply", "text",
        "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz + "property float u\nproperty float v\n" + kCorners +
            "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 .5 0 1\n4 0 1 2 3\n3 0 1 2\n");
  write("ply", "binary", ply_binary());
  write("ply", "big",
        "ply\nformat binary_big_endian 1.0\ncomment c\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
        "property uchar z\nelement strip 1\nproperty list uchar short k\nend_header\n\1\2\3\1" +
            std::string(2, '\1'));
  write("off", "text",
        "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 .5 0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n");
  write("off", "colors", "STCOFF\n# c\n3 1 0\n0 0 0 255 0 0 0 0\n1 0 0 255 0 0 1 0\n1 1 0 255 0 0 1 1\n3 0 1 2\n");
  write("off", "binary", off_binary());
  write("stl", "text",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet "
        "normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 .5\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  write("stl", "binary", stl_binary());
  return files == 13 ? 0 : 1;
}
