#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "host_sim/batch/deal.hpp"
#include "host_sim/batch/run_batch.hpp"

namespace {

using hal::files::InputError;
using hal::files::Interruption;
using host_sim::batch::Answer;
using host_sim::batch::Batch;
using host_sim::batch::deal;
using host_sim::batch::error_line;
using host_sim::batch::Means;
using host_sim::batch::Ranks;
using host_sim::batch::run_batch;

constexpr int kStatus = 7;

// Where the tests are built with MPI, it starts once in a process: run them by ctest.

class RunBatch : public testing::Test {
 protected:
  RunBatch() {
    batch_.label = "test";
    batch_.threads = 3;
    batch_.list = [] { return std::vector<std::string>{"a", "b", std::string("c\0d", 3)}; };
    batch_.work = [](const std::string& piece, const Means&) {
      return Answer{"row of " + piece, "{}", "", {"found", piece.substr(0, 1)}};
    };
    batch_.refuse = [](const std::string& piece, const std::exception& error) {
      return Answer{"none", "{}", error_line(error, piece), {}};
    };
    batch_.report = [this](const std::vector<Answer>& answers) {
      answers_ = answers;
      return kStatus;
    };
  }

  host_sim::batch::Ranks ranks_;
  Batch batch_;
  std::vector<Answer> answers_;
};

TEST_F(RunBatch, TellsTheAnswersInOrder) {
  EXPECT_EQ(run_batch(ranks_, batch_), kStatus);
  ASSERT_EQ(answers_.size(), 3U);
  EXPECT_EQ(answers_[0].row, "row of a");
  EXPECT_EQ(answers_[1].found, (std::vector<std::string>{"found", "b"}));
  EXPECT_EQ(answers_[2].row, std::string("row of c\0d", 10));
}

TEST_F(RunBatch, APieceThatFailsDoesNotStopTheOthers) {
  batch_.work = [work = batch_.work](const std::string& piece, const Means& means) {
    if (piece == "a") {
      throw InputError("file", 3, 0, "nonsense", "sense");
    }
    return piece == "b" ? throw std::domain_error("no\nway") : work(piece, means);
  };
  EXPECT_EQ(run_batch(ranks_, batch_), kStatus);
  ASSERT_EQ(answers_.size(), 3U);
  EXPECT_EQ(answers_[0].error, "file:3: nonsense; accepted: sense");
  EXPECT_EQ(answers_[1].error, "b: no\\nway");
  EXPECT_EQ(answers_[2].error, "");
}

TEST_F(RunBatch, WhatIsNoMatterOfOnePieceEndsAll) {
  batch_.work = [](const std::string&, const Means&) -> Answer { throw Interruption(); };
  EXPECT_THROW(run_batch(ranks_, batch_), Interruption);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(RunBatch, MemoryThatRunsOutEndsAll) {
  batch_.work = [](const std::string&, const Means&) -> Answer { throw std::bad_alloc(); };
  EXPECT_THROW(run_batch(ranks_, batch_), std::runtime_error);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(RunBatch, NothingIsTriedWhereTheListFails) {
  batch_.list = []() -> std::vector<std::string> { throw InputError("x", 0, 0, "bad", "good"); };
  batch_.work = [](const std::string&, const Means&) -> Answer {
    ADD_FAILURE();
    return {};
  };
  EXPECT_THROW(run_batch(ranks_, batch_), InputError);
}

TEST_F(RunBatch, SharesItsThreadsAmongFewPieces) {
  batch_.threads = 7;
  batch_.work = [](const std::string&, const Means& means) {
    EXPECT_EQ(means.threads, 2U);
    means.progress(0.5);
    return Answer{};
  };
  EXPECT_EQ(run_batch(ranks_, batch_), kStatus);
}

// Where the tests are built with MPI, it starts once in a process: run them by ctest.

TEST(Deal, GivesAnswersInOrderWithAnyBytes) {
  Ranks ranks;
  ASSERT_EQ(ranks.count(), 1U);
  EXPECT_EQ(ranks.broadcast("text"), "text");
  const std::vector<std::string> answers =
      deal(ranks, 100, 3, [](std::size_t i) { return std::string(i, '\0') + std::to_string(i); });
  ASSERT_EQ(answers.size(), 100U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i], std::string(i, '\0') + std::to_string(i));
  }
  EXPECT_TRUE(ranks.has_left());
}

TEST(Deal, TellsWhyTheWorkFailed) {
  Ranks ranks;
  try {
    deal(ranks, 5, 2, [](std::size_t i) -> std::string {
      return i == 3 ? throw std::runtime_error("three") : "";
    });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "three");
  }
  EXPECT_TRUE(ranks.has_left());
}

TEST(Deal, AnInterruptionStaysOne) {
  Ranks ranks;
  EXPECT_THROW(
      deal(ranks, 2, 1, [](std::size_t) -> std::string { throw hal::files::Interruption(); }),
      hal::files::Interruption);
}

TEST(Deal, NothingToDoIsNoError) {
  Ranks ranks;
  EXPECT_TRUE(deal(ranks, 0, 0, [](std::size_t) { return std::string(); }).empty());
}

}  // namespace
