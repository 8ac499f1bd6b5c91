#include "renderer/image/picture.h"

#include <gmock/gmock.h>

#include "renderer/image/picture_bytes_for_tests.h"
#include "renderer/image/picture_header.h"
#include "renderer/image/read_picture.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Picture decoded(const std::string& name, const std::string& bytes) {
  return read_picture(write_picture_test_file(name, bytes));
}

/// The text of the BadPicture that the bytes end in; empty if they are read.
std::string defect(const std::string& name, const std::string& bytes) {
  try {
    decoded(name, bytes);
  } catch (const BadPicture& bad) {
    EXPECT_STRNE(bad.what(), "");
    return bad.what();
  }
  return "";
}

std::string rgb_png() { return png_bytes(2, 1, 8, 2, "\0\x01\x02\x03\xfd\xfe\xff"s); }

TEST(ReadPicture, RgbPng) {
  const Picture picture = decoded("rgb.png", rgb_png());
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
  EXPECT_THAT(picture.samples, ElementsAre(1, 2, 3, 253, 254, 255));
  EXPECT_FALSE(picture.transparent);
  EXPECT_FALSE(picture.is_linear());
}

TEST(ReadPicture, RowsCountFromTheTop) {
  const Picture picture = decoded("rows.png", png_bytes(1, 2, 8, 2, "\0\x01\x01\x01\0\x09\x09\x09"s));
  EXPECT_EQ(picture.pixel(0, 0)[0], 1);
  EXPECT_EQ(picture.pixel(0, 1)[0], 9);
}

TEST(ReadPicture, SixteenBitPngGivesFractionsOfLevels) {
  // 65535 / 257 = 255, 257 / 257 = 1, 128 / 257 = 0.498.
  const Picture picture = decoded("deep.png", png_bytes(1, 1, 16, 2, "\0\xff\xff\x01\x01\x00\x80"s));
  EXPECT_THAT(picture.samples, ElementsAre(255, 1, 128.0F / 257));
}

TEST(ReadPicture, GreyPngsOfEveryDepthGiveThreeEqualChannels) {
  EXPECT_THAT(decoded("grey.png", png_bytes(2, 1, 8, 0, "\0\x07\xc8"s)).samples, ElementsAre(7, 7, 7, 200, 200, 200));
  EXPECT_THAT(decoded("bits.png", png_bytes(2, 1, 1, 0, "\0\x40"s)).samples, ElementsAre(0, 0, 0, 255, 255, 255));
  // Two bits: 01 is a third of 255.
  EXPECT_THAT(decoded("two.png", png_bytes(1, 1, 2, 0, "\0\x40"s)).samples, ElementsAre(85, 85, 85));
  EXPECT_THAT(decoded("grey16.png", png_bytes(1, 1, 16, 0, "\0\x01\x01"s)).samples, ElementsAre(1, 1, 1));
}

TEST(ReadPicture, PalettePngGivesItsColors) {
  const std::string palette = png_chunk("PLTE", "\x0a\x14\x1e\xc8\x64\x32"s);
  const Picture picture = decoded("palette.png", png_bytes(2, 1, 8, 3, "\0\x01\x00"s, palette));
  EXPECT_THAT(picture.samples, ElementsAre(200, 100, 50, 10, 20, 30));
  EXPECT_FALSE(picture.transparent);
}

TEST(ReadPicture, AlphaIsReportedAndNotMultipliedIn) {
  const Picture opaque = decoded("opaque.png", png_bytes(1, 1, 8, 6, "\0\x64\x65\x66\xff"s));
  EXPECT_THAT(opaque.samples, ElementsAre(100, 101, 102));
  EXPECT_FALSE(opaque.transparent);
  const Picture half = decoded("half.png", png_bytes(1, 1, 8, 6, "\0\x64\x65\x66\x80"s));
  EXPECT_THAT(half.samples, ElementsAre(100, 101, 102));
  EXPECT_TRUE(half.transparent);
  const Picture grey = decoded("greyalpha.png", png_bytes(1, 1, 8, 4, "\0\x64\x00"s));
  EXPECT_THAT(grey.samples, ElementsAre(100, 100, 100));
  EXPECT_TRUE(grey.transparent);
  const Picture palette = decoded(
      "trns.png", png_bytes(1, 1, 8, 3, "\0\x00"s, png_chunk("PLTE", "\x0a\x14\x1e"s) + png_chunk("tRNS", "\x7f"s)));
  EXPECT_THAT(palette.samples, ElementsAre(10, 20, 30));
  EXPECT_TRUE(palette.transparent);
}

TEST(ReadPicture, ATransparentColorOfAPngCountsAsAlpha) {
  const std::string seven = png_chunk("tRNS", "\0\x07"s);
  EXPECT_TRUE(decoded("key.png", png_bytes(2, 1, 8, 0, "\0\x08\x07"s, seven)).transparent);
  EXPECT_FALSE(decoded("key.png", png_bytes(2, 1, 8, 0, "\0\x08\x09"s, seven)).transparent);
}

TEST(ReadPicture, GammaOfAPngIsNotApplied) {
  const std::string linear = png_chunk("gAMA", big_endian_bytes(100000));
  EXPECT_THAT(decoded("gamma.png", png_bytes(1, 1, 8, 2, "\0\x01\x80\xfe"s, linear)).samples, ElementsAre(1, 128, 254));
}

/// Adam7 [PNG, section 8.2]: of 2 x 2 pixels the first pass has (0, 0), the sixth (1, 0), the seventh the second row.
TEST(ReadPicture, InterlacedPngsAreInOrder) {
  const std::string size = big_endian_bytes(2) + big_endian_bytes(2);
  const std::string bytes = "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", size + "\x08\0\0\0\x01"s) +
                            png_chunk("IDAT", zlib_stored("\0\x01\0\x02\0\x03\x04"s)) + png_chunk("IEND", "");
  EXPECT_THAT(decoded("adam7.png", bytes).samples, ElementsAre(1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4));
}

TEST(ReadPicture, PortablePixmapsInTextAndBytes) {
  EXPECT_THAT(decoded("a.ppm", "P3\n# a comment\n2 1\n255\n1 2 3\n253 254 255\n").samples,
              ElementsAre(1, 2, 3, 253, 254, 255));
  EXPECT_THAT(decoded("b.ppm", "P6 2 1 255\n\x01\x02\x03\xfd\xfe\xff"s).samples, ElementsAre(1, 2, 3, 253, 254, 255));
  const Picture rows = decoded("c.ppm", "P6\n1 2\n255\n\x01\x01\x01\x09\x09\x09"s);
  EXPECT_EQ(rows.pixel(0, 0)[0], 1);
  EXPECT_EQ(rows.pixel(0, 1)[0], 9);
  EXPECT_EQ(rows.format, PictureFormat::ppm);
}

TEST(ReadPicture, ContentOfAnotherFormatThanTheNameIsRefused) {
  EXPECT_THAT(defect("tiff.png", "II*\0\x08\0\0\0"s + std::string(64, '\0')), HasSubstr("this is not a PNG file"));
  EXPECT_THAT(defect("jpeg.png", "\xff\xd8\xff\xe0\0\x10JFIF\0"s + std::string(64, '\0')),
              HasSubstr("this is not a PNG file"));
  EXPECT_THAT(defect("ppm.png", "P6 1 1 255\nabc"), HasSubstr("this is not a PNG file"));
  EXPECT_THAT(defect("png.exr", rgb_png()), HasSubstr("this is not an EXR file"));
  EXPECT_THAT(defect("png.ppm", rgb_png()), HasSubstr("this is not a PPM file"));
  EXPECT_THAT(defect("grey.ppm", "P5 1 1 255\na"), HasSubstr("this is not a PPM file"));
  EXPECT_THAT(defect("empty.png", ""), HasSubstr("this is not a PNG file"));
}

TEST(ReadPicture, FilesThatCannotBeOpenedAreInputErrors) {
  EXPECT_THROW(read_picture(picture_test_file("none.png")), InputError);
  EXPECT_THROW(decoded("a.jpg", rgb_png()), InputError);
  EXPECT_THROW(decoded("png", rgb_png()), InputError);
  std::filesystem::create_directories(picture_test_file("folder.png"));
  EXPECT_THROW(read_picture(picture_test_file("folder.png")), InputError);
}

TEST(ReadPicture, DamagedPngsAreRefused) {
  const std::string whole = png_bytes(8, 8, 8, 2, std::string(8 * 25, '\0'));
  EXPECT_EQ(defect("whole.png", whole), "");
  int cuts = 0;
  for (const std::size_t length : {8, 20, 30, 45, 60, 120, 200}) {
    EXPECT_NE(defect("cut.png", whole.substr(0, length)), "") << length;
    ++cuts;
  }
  EXPECT_EQ(cuts, 7);
  std::string bad_crc = rgb_png();
  bad_crc[8 + 25 + 8 + 10] ^= 0x01;  // within the data of the IDAT chunk
  EXPECT_NE(defect("crc.png", bad_crc), "");
  std::string bad_header_crc = rgb_png();
  bad_header_crc[8 + 8 + 13] ^= 0x01;
  EXPECT_NE(defect("headercrc.png", bad_header_crc), "");
}

TEST(ReadPicture, DamagedExrsAreRefused) {
  write_image(Image(16, 16), picture_test_file("whole.exr"));
  const std::string whole = bytes_of(picture_test_file("whole.exr"));
  EXPECT_EQ(defect("copy.exr", whole), "");
  for (const std::size_t length :
       {std::size_t{4}, std::size_t{9}, std::size_t{100}, whole.size() / 2, whole.size() - 1})
    EXPECT_NE(defect("cut.exr", whole.substr(0, length)), "") << length;
}

TEST(ReadPicture, DamagedPixmapsAreRefused) {
  EXPECT_NE(defect("cut.ppm", "P6 2 2 255\nabcdef"), "");
  EXPECT_THAT(defect("word.ppm", "P6 two 2 255\n"), HasSubstr("the PPM header is not three whole numbers"));
  EXPECT_THAT(defect("header.ppm", "P6 2 2"), HasSubstr("the PPM header is not three whole numbers"));
  EXPECT_THAT(defect("comment.ppm", "P6 # without an end"), HasSubstr("the PPM header is not three whole numbers"));
  EXPECT_THAT(defect("maximum.ppm", "P6 1 1 0\nabc"), HasSubstr("the PPM maximum is 0"));
  EXPECT_THAT(defect("maximum.ppm", "P6 1 1 65536\nabc"), HasSubstr("the PPM maximum is 65536"));
}

TEST(PictureHeader, SizesOfNothingAndOfTooMuchAreRefused) {
  EXPECT_THAT(defect("zero.png", png_header(0, 5, 8, 2)), HasSubstr("its size is 0x5, expected 1 to 65535 a side"));
  EXPECT_THAT(defect("zero.png", png_header(5, 0, 8, 2)), HasSubstr("its size is 5x0"));
  EXPECT_THAT(defect("wide.png", png_header(65536, 1, 8, 2)), HasSubstr("its size is 65536x1"));
  EXPECT_THAT(defect("huge.png", png_header(2'000'000'000, 2'000'000'000, 16, 6)),
              HasSubstr("its size is 2000000000x2000000000"));
  EXPECT_THAT(defect("zero.ppm", "P6 0 5 255\n"), HasSubstr("its size is 0x5"));
  EXPECT_THAT(defect("huge.ppm", "P6 999999999 999999999 255\n"), HasSubstr("its size is 999999999x999999999"));
  EXPECT_THAT(defect("huge.exr", exr_header(0x7ffffffe, 3)), HasSubstr("its size is 2147483647x4"));
  EXPECT_THAT(defect("negative.exr", exr_header(0xfffffffe, 3)), HasSubstr("its size is -1x4"));
  EXPECT_THAT(defect("none.exr", "\x76\x2f\x31\x01\x02\0\0\0\0"s), HasSubstr("no data window"));
}

TEST(PictureHeader, IsReadWithoutTheRest) {
  const PictureHeader png = read_picture_header(write_picture_test_file("only.png", png_header(65535, 7, 8, 2)));
  EXPECT_EQ(png.width, 65535);
  EXPECT_EQ(png.height, 7);
  EXPECT_EQ(read_picture_header(write_picture_test_file("only.exr", exr_header(9, 4))).width, 10);
  EXPECT_EQ(read_picture_header(write_picture_test_file("only.ppm", "P3\n#x\n12 # y\n34\n255\n")).height, 34);
}

TEST(PictureFormat, HasNames) {
  EXPECT_EQ(to_string(PictureFormat::png), "PNG");
  EXPECT_EQ(to_string(PictureFormat::exr), "EXR");
  EXPECT_EQ(to_string(PictureFormat::ppm), "PPM");
}

}  // namespace
}  // namespace plumb
