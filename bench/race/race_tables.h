#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace plumb::bench {

/// Says on standard error which row is done, and prints the tables of all rows on standard output at the end.
class RaceTables : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& report) override;
  void Finalize() override;
  /// Whether a row ended with an error.
  bool failed() const { return failed_; }

 private:
  std::vector<const Run*> of_table(const std::string& table) const;
  void print_speeds(const std::string& table) const;
  void print_differences() const;
  void print_builds() const;
  void print_scaling() const;
  void print_growth() const;
  void print_frame() const;

  std::vector<Run> runs_;
  bool failed_ = false;
};

}  // namespace plumb::bench
