#include "tools/adapters/java_program.h"

#include <stdlib.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The number of places.
int replace_all(std::string& text, const std::string& what, const std::string& by) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()), ++count)
    text.replace(at, what.size(), by);
  return count;
}

}  // namespace

JavaProgram::JavaProgram() {
  std::string name = (fs::temp_directory_path() / "plumb-java-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
  folder_ = fs::canonical(name);
  fs::create_directory(folder_ / "src");
  overlay(fs::path(PLUMB_SOURCE_DIR) / "examples/java-framework");
}

JavaProgram::~JavaProgram() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void JavaProgram::overlay(const fs::path& folder) {
  fs::copy(folder, folder_ / "src", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

std::vector<fs::path> JavaProgram::sources() const {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "src"))
    if (entry.path().extension() == ".java") files.push_back(entry.path());
  return files;
}

void JavaProgram::replace(const std::string& file, const std::string& what, const std::string& by) {
  std::string text = content(folder_ / "src" / file);
  if (replace_all(text, what, by) == 0) throw std::runtime_error("'" + what + "' does not occur in " + file);
  std::ofstream(folder_ / "src" / file) << text;
}

void JavaProgram::replace_everywhere(const std::string& what, const std::string& by) {
  int count = 0;
  for (const fs::path& file : sources()) {
    std::string text = content(file);
    count += replace_all(text, what, by);
    std::ofstream(file) << text;
  }
  if (count == 0) throw std::runtime_error("'" + what + "' does not occur");
}

void JavaProgram::write(const std::string& file, const std::string& text) const {
  std::ofstream(folder_ / file) << text;
}

void JavaProgram::compile() const {
  // The flags halve the time of a program that runs for a second.
  std::ostringstream command;
  command << "cd '" << folder_.string()
          << "' && javac -J-XX:TieredStopAtLevel=1 -J-XX:+UseSerialGC -nowarn -encoding UTF-8 -d out '"
          << PLUMB_SOURCE_DIR << "/tools/adapters/java/PlumbProbe.java'";
  for (const fs::path& file : sources()) command << " '" << file.string() << "'";
  command << " >javac.txt 2>&1";
  if (std::system(command.str().c_str()) != 0) throw std::runtime_error("javac: " + content(folder_ / "javac.txt"));
}

std::vector<nlohmann::json> JavaProgram::ask(std::vector<nlohmann::json> questions, const std::string& options) {
  questions.push_back({{"ask", "quit"}});
  std::ofstream stream(folder_ / "questions.txt");
  for (std::size_t i = 0; i < questions.size(); ++i) {
    questions[i]["id"] = i + 1;
    stream << questions[i].dump() << '\n';
  }
  stream.close();
  const std::string command = "cd '" + folder_.string() + "' && java -XX:TieredStopAtLevel=1 -XX:+UseSerialGC " +
                              options + " -cp out PlumbProbe <questions.txt >answers.txt 2>log.txt";
  const int status = std::system(command.c_str());
  log_ = content(folder_ / "log.txt");
  if (status != 0) throw std::runtime_error("java: " + log_);

  std::vector<nlohmann::json> answers;
  std::istringstream lines(content(folder_ / "answers.txt"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("{\"plumb\":"))
      answers.push_back(nlohmann::json::parse(line));
    else
      log_ += line + '\n';
  }
  // The last question, quit, has no answer; the greeting comes unasked.
  if (answers.size() != questions.size()) throw std::runtime_error("answers are missing: " + log_);
  for (std::size_t i = 1; i < answers.size(); ++i)
    if (answers[i]["id"] != i) throw std::runtime_error("an answer has the wrong id: " + answers[i].dump());
  return answers;
}

}  // namespace plumb
