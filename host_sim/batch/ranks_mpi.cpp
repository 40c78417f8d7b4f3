#include <mpi.h>

#include <chrono>
#include <exception>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "hal/files/interruption.hpp"
#include "host_sim/batch/ranks.hpp"

namespace host_sim::batch {

using hal::files::stop_if_interrupted;

namespace {

constexpr int kFirst = 0;
constexpr std::chrono::milliseconds kBetweenLooks{1};

// The signal that stops this rank mostly stops rank 0 too, which then has files to remove; mpirun
// itself gives them a second.
constexpr std::chrono::milliseconds kToRemoveFiles{500};

// Blocking calls of MPI keep a core busy and hear no signal.
void wait_for(MPI_Request& request) {
  for (;;) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) {
      return;
    }
    stop_if_interrupted();
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

int as_count(std::size_t size) {
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("a batch has more than 2 GB of results");
  }
  return static_cast<int>(size);
}

std::size_t ranks_on_this_machine() {
  MPI_Comm machine = MPI_COMM_NULL;
  int count = 1;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &count);
  MPI_Comm_free(&machine);
  return static_cast<std::size_t>(count);
}

std::vector<int> gather_sizes(int size, std::size_t count) {
  std::vector<int> sizes(count);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Igather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, kFirst, MPI_COMM_WORLD, &request);
  wait_for(request);
  return sizes;
}

std::vector<int> places_of(const std::vector<int>& sizes) {
  std::size_t total = 0;
  std::vector<int> places;
  for (const int size : sizes) {
    places.push_back(as_count(total));
    total += static_cast<std::size_t>(size);
  }
  as_count(total);
  return places;
}

}  // namespace

Ranks::Ranks() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  int rank = 0;
  int count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  rank_ = static_cast<std::size_t>(rank);
  count_ = static_cast<std::size_t>(count);
  on_this_machine_ = ranks_on_this_machine();
}

Ranks::~Ranks() {
  if (left_ || count_ == 1 || std::uncaught_exceptions() == 0) {
    MPI_Finalize();
    return;
  }
  if (rank_ != kFirst) {
    std::this_thread::sleep_for(kToRemoveFiles);
  }
  MPI_Abort(MPI_COMM_WORLD, 1);
}

std::string Ranks::broadcast(std::string text) {
  int size = as_count(text.size());
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&size, 1, MPI_INT, kFirst, MPI_COMM_WORLD, &request);
  wait_for(request);
  text.resize(static_cast<std::size_t>(size));
  MPI_Ibcast(text.data(), size, MPI_CHAR, kFirst, MPI_COMM_WORLD, &request);
  wait_for(request);
  return text;
}

std::vector<std::string> Ranks::gather(const std::string& text) {
  const int size = as_count(text.size());
  const bool first = rank_ == kFirst;
  const std::vector<int> sizes = gather_sizes(size, first ? count_ : 0);
  const std::vector<int> places = places_of(sizes);
  std::string all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), '\0');
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Igatherv(text.data(), size, MPI_CHAR, all.data(), sizes.data(), places.data(), MPI_CHAR,
               kFirst, MPI_COMM_WORLD, &request);
  wait_for(request);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    texts.push_back(
        all.substr(static_cast<std::size_t>(places[i]), static_cast<std::size_t>(sizes[i])));
  }
  return texts;
}

}  // namespace host_sim::batch
