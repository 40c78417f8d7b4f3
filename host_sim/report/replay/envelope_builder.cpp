#include "host_sim/report/replay/envelope_builder.hpp"

#include <algorithm>

namespace host_sim {

EnvelopeBuilder::EnvelopeBuilder(std::size_t max_buckets)
    : max_buckets_(std::max<std::size_t>(2, max_buckets + max_buckets % 2)) {}

void EnvelopeBuilder::push(double time_s, double tension_N) {
  const Bucket sample{time_s, time_s, tension_N, tension_N};
  if (!buckets_.empty() && samples_in_last_ < samples_per_bucket_) {
    merge(buckets_.back(), sample);
    ++samples_in_last_;
    return;
  }
  if (buckets_.size() == max_buckets_) {
    halve();
  }
  buckets_.push_back(sample);
  samples_in_last_ = 1;
}

Envelope EnvelopeBuilder::finish() const {
  Envelope envelope;
  envelope.samples_per_bucket = samples_per_bucket_;
  for (const Bucket& bucket : buckets_) {
    envelope.time_s.push_back(bucket.first_s + (bucket.last_s - bucket.first_s) / 2);
    envelope.low_N.push_back(bucket.low_N);
    envelope.high_N.push_back(bucket.high_N);
  }
  return envelope;
}

void EnvelopeBuilder::merge(Bucket& into, const Bucket& later) {
  into.last_s = later.last_s;
  into.low_N = std::min(into.low_N, later.low_N);
  into.high_N = std::max(into.high_N, later.high_N);
}

void EnvelopeBuilder::halve() {
  const std::size_t half = buckets_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    Bucket merged = buckets_[2 * i];
    merge(merged, buckets_[2 * i + 1]);
    buckets_[i] = merged;
  }
  buckets_.resize(half);
  samples_per_bucket_ *= 2;
}

}  // namespace host_sim
