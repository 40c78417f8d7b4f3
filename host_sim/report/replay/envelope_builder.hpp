#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Reduces a stream of samples to at most `max_buckets` bands. A bucket holds a run of neighbouring
/// samples; when all are full, pairs merge and the runs double. Every bucket keeps its exact
/// minimum and maximum.
class EnvelopeBuilder {
 public:
  /// `max_buckets` is rounded up to an even number of at least 2.
  explicit EnvelopeBuilder(std::size_t max_buckets = 2000);

  /// Adds a finite sample; time must not fall. Amortised constant time.
  void push(double time_s, double tension_N);

  [[nodiscard]] Envelope finish() const;

 private:
  struct Bucket {
    double first_s;
    double last_s;
    double low_N;
    double high_N;
  };
  static void merge(Bucket& into, const Bucket& later);
  void halve();

  std::size_t max_buckets_;
  std::uint64_t samples_per_bucket_ = 1;
  std::uint64_t samples_in_last_ = 0;
  std::vector<Bucket> buckets_;
};

}  // namespace host_sim
