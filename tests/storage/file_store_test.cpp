#include "firmware/storage/file_store.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/storage/folder.hpp"
#include "tests/storage/lives.hpp"

namespace storage_test {
namespace {

using hal::Error;
using storage::FileError;
using Store = storage::FileStore<2>;

Store opened(const Folder& folder) {
  return std::get<Store>(Store::open(folder.path()));
}

template <class StoreT = Store>
std::string refusal(const std::string& path) {
  const auto result = StoreT::open(path);
  const auto* error = std::get_if<FileError>(&result);
  return error != nullptr ? to_string(*error) : "opened";
}

/// A folder with three saves, two blocks and two entries.
class FileStore : public testing::Test {
 protected:
  void SetUp() override {
    Store store = opened(folder_);
    ASSERT_EQ(store.save(records_of<2>(1)), Error::none);
    ASSERT_EQ(store.save_parameters(0, block_of(1)), Error::none);
    ASSERT_EQ(store.append(entry_of(1)), Error::none);
    ASSERT_EQ(store.append(entry_of(2)), Error::none);
    ASSERT_EQ(store.save(records_of<2>(2)), Error::none);
    ASSERT_EQ(store.save(records_of<2>(3)), Error::none);
  }

  Folder folder_;
};

constexpr const char* kAccepted =
    "; accepted: an existing folder that this controller may write, used by no other";

TEST_F(FileStore, AMissingFolderIsRefused) {
  const std::string path = folder_.file("none");
  EXPECT_EQ(refusal(path), path + ": there is no such folder" + kAccepted);
  EXPECT_FALSE(folder_.has("none"));
}

TEST_F(FileStore, AFileInPlaceOfTheFolderIsRefused) {
  const std::string path = folder_.file("life");
  EXPECT_EQ(refusal(path), path + ": cannot be used: Not a directory" + kAccepted);
}

TEST_F(FileStore, AFolderThatCannotBeWrittenIsRefused) {
  if (::geteuid() == 0) {
    EXPECT_EQ(refusal("/proc").rfind("/proc: ", 0), 0u) << refusal("/proc");
    return;
  }
  ASSERT_EQ(::chmod(folder_.file("lock").c_str(), 0400), 0);
  EXPECT_EQ(refusal(folder_.path()),
            folder_.path() + ": cannot be used: Permission denied" + kAccepted);
}

TEST_F(FileStore, ASecondControllerIsKeptOut) {
  {
    const Store first = opened(folder_);
    EXPECT_EQ(refusal(folder_.path()),
              folder_.path() + ": in use by another controller" + kAccepted);
  }
  EXPECT_EQ(refusal(folder_.path()), "opened");
}

TEST_F(FileStore, ADamagedFileGivesWayToTheSaveBefore) {
  folder_.flip("life", 100);
  {
    Store store = opened(folder_);
    EXPECT_TRUE(same_life(*store.load(0), record_of(0, 2)));
    EXPECT_EQ(store.load_parameters(0), block_of(1));
    EXPECT_FALSE(store.past_lost());
    EXPECT_EQ(store.sequence(), 3u);
    ASSERT_EQ(store.notices().size(), 1u);
    EXPECT_EQ(to_string(store.notices()[0]),
              folder_.file("life") +
                  ": damaged, the CRC-32 at its end does not fit; accepted: a whole life file; "
                  "the save before is used");
    ASSERT_EQ(store.save(records_of<2>(4)), Error::none);
    EXPECT_EQ(store.sequence(), 4u);
  }
  // The damaged file was put aside, the good one was not lost to it.
  EXPECT_TRUE(folder_.has("life.damaged"));
  folder_.flip("life", 100);
  EXPECT_TRUE(same_life(*opened(folder_).load(1), record_of(1, 2)));
}

TEST_F(FileStore, EveryDamageIsNoticed) {
  const auto whole = folder_.read("life");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    folder_.flip("life", at);
    const auto result = Store::open(folder_.path());
    const Store* store = std::get_if<Store>(&result);
    ASSERT_TRUE(store != nullptr) << at;
    ASSERT_TRUE(same_life(*store->load(0), record_of(0, 2))) << at;
    ASSERT_EQ(store->notices().size(), 1u) << at;
    folder_.write("life", whole);
  }
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder_.write("life", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    const Store store = opened(folder_);
    ASSERT_TRUE(same_life(*store.load(0), record_of(0, 2))) << size;
  }
  folder_.write("life", whole);
  EXPECT_TRUE(same_life(*opened(folder_).load(0), record_of(0, 3)));
}

TEST_F(FileStore, AFileThatHasGrownGivesWayToTheSaveBefore) {
  const auto whole = folder_.read("life");
  for (const std::size_t more : {1u, 24u, 4'000u, 5'000u, 1'000'000u}) {
    auto grown = whole;
    grown.insert(grown.end(), more, '\0');
    folder_.write("life", grown);
    ASSERT_EQ(refusal(folder_.path()), "opened") << more;
    const Store store = opened(folder_);
    EXPECT_TRUE(same_life(*store.load(0), record_of(0, 2))) << more;
    EXPECT_FALSE(store.past_lost()) << more;
    ASSERT_EQ(store.notices().size(), 1u) << more;
    EXPECT_EQ(store.notices()[0].path, folder_.file("life"));
  }
  // 16 bytes of head, 4 + 88 + 4 + 616 for each of 32 tendons, and 4.
  EXPECT_EQ(opened(folder_).notices()[0].what,
            "longer than a life file, 22804 bytes at most; accepted: a whole life file; the save "
            "before is used");
  folder_.write("life.previous", folder_.read("life"));
  const Store store = opened(folder_);
  EXPECT_TRUE(store.past_lost());
  EXPECT_EQ(store.notices().size(), 2u);
}

TEST_F(FileStore, TheLifeOfTheMostTendonsIsAnotherConfigurationAndNotDamaged) {
  const Folder folder;
  {
    auto many = storage::FileStore<32>::open(folder.path());
    ASSERT_EQ(std::get<storage::FileStore<32>>(many).save(records_of<32>(1)), Error::none);
  }
  EXPECT_EQ(refusal(folder.path()),
            folder.file("life") +
                ": it holds the life of 32 tendons; accepted: as many as are configured, 2");
}

TEST_F(FileStore, TheLastSequenceIsNotFollowedByTheFirst) {
  using Image = storage::FileImage<2>;
  const auto whole = folder_.read("life");
  const auto decoded = storage::decode_image<2>(std::as_bytes(std::span(whole)));
  Image image = std::get<Image>(decoded);
  image.sequence = 0xffff'ffff;
  const auto bytes = storage::encode(image);
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  folder_.write("life.previous", {first, first + bytes.size()});
  folder_.flip("life", 100);
  Store store = opened(folder_);
  EXPECT_EQ(store.sequence(), 0xffff'ffffu);
  EXPECT_EQ(store.save(records_of<2>(4)), Error::full);
}

TEST_F(FileStore, ALogThatHasGrownIsReadAndGoesOn) {
  auto grown = folder_.read("authority.log");
  grown.insert(grown.end(), 24 * 65'536 + 1 - grown.size(), '\0');
  folder_.write("authority.log", grown);
  {
    ASSERT_EQ(refusal(folder_.path()), "opened");
    Store store = opened(folder_);
    ASSERT_EQ(store.notices().size(), 1u);
    EXPECT_EQ(to_string(store.notices()[0]),
              folder_.file("authority.log") +
                  ": longer than the 65536 entries of a log; all from entry 2 on is ignored");
    EXPECT_EQ(store.log(1)->detail, entry_of(2).detail);
    EXPECT_FALSE(store.log(2));
    ASSERT_EQ(store.append(entry_of(3)), Error::none);
  }
  const Store store = opened(folder_);
  EXPECT_EQ(store.log(2)->detail, entry_of(3).detail);
  EXPECT_FALSE(store.log(3));
}

TEST_F(FileStore, WithBothDamagedThePastIsLostAndThatIsRemembered) {
  folder_.flip("life", 100);
  folder_.flip("life.previous", 100);
  {
    Store store = opened(folder_);
    EXPECT_FALSE(store.load(0));
    EXPECT_TRUE(store.past_lost());
    ASSERT_EQ(store.notices().size(), 2u);
    EXPECT_EQ(store.notices()[0].path, folder_.file("life"));
    EXPECT_NE(store.notices()[0].what.find("there is no save before to use"), std::string::npos);
    EXPECT_EQ(store.notices()[1].path, folder_.file("life.previous"));
    ASSERT_EQ(store.save_parameters(0, block_of(9)), Error::none);
  }
  {
    Store store = opened(folder_);
    EXPECT_TRUE(store.past_lost());
    ASSERT_EQ(store.save(records_of<2>(0)), Error::none);
    EXPECT_TRUE(store.load(1)->past_lost);
    auto records = records_of<2>(1);
    records[0] = record_of(0, 1, 1, 1);
    ASSERT_EQ(store.save(records), Error::none);
    EXPECT_TRUE(store.past_lost());
    records = records_of<2>(2);
    records[0] = record_of(0, 2, 1, 1);
    records[1] = record_of(1, 2, 1, 2);
    ASSERT_EQ(store.save(records), Error::none);
    EXPECT_FALSE(store.past_lost());
  }
  EXPECT_FALSE(opened(folder_).past_lost());
}

TEST_F(FileStore, AMissingFileThatTheLogTellsOfIsALoss) {
  std::filesystem::remove(folder_.file("life"));
  {
    const Store store = opened(folder_);
    EXPECT_TRUE(same_life(*store.load(0), record_of(0, 2)));
    EXPECT_FALSE(store.past_lost());
  }
  std::filesystem::remove(folder_.file("life.previous"));
  const Store store = opened(folder_);
  EXPECT_FALSE(store.load(0));
  EXPECT_TRUE(store.past_lost());
  ASSERT_EQ(store.notices().size(), 1u);
  EXPECT_EQ(store.notices()[0].path, folder_.file("life"));
}

TEST_F(FileStore, TheLifeOfAnotherConfigurationIsRefusedAndLeftAlone) {
  const auto before = folder_.read("life");
  EXPECT_EQ(refusal<storage::FileStore<3>>(folder_.path()),
            folder_.file("life") +
                ": it holds the life of 2 tendons; accepted: as many as are configured, 3");
  auto other = before;
  other[4] = 4;
  const auto covered = std::as_bytes(std::span(other).first(other.size() - 4));
  lifemodel::ByteWriter(std::as_writable_bytes(std::span(other).last(4)))
      .u32(lifemodel::crc32(covered));
  folder_.write("life", other);
  EXPECT_EQ(refusal(folder_.path()), folder_.file("life") + ": schema 4; accepted: schema 1 to 3");
  EXPECT_EQ(folder_.read("life"), other);
}

/// By hand. Of schema 1, 84 bytes of a block follow the record at once; of schema 2 their size and
/// 572 bytes do.
TEST_F(FileStore, AFileOfAFormerSchemaIsReadWithItsBlocks) {
  for (const std::uint32_t schema : {1u, 2u}) {
    SCOPED_TRACE(schema);
    const std::size_t block_at = schema == 1 ? 68 : 72;
    const std::size_t room = schema == 1 ? 84 : 572;
    const std::size_t tendon_bytes = block_at + room;
    std::vector<std::byte> file(16 + 2 * tendon_bytes + 4);
    lifemodel::ByteWriter out(file);
    for (const std::uint32_t word : {0x46534c54u, schema, 2u, 7u}) {
      out.u32(word);
    }
    for (std::size_t tendon = 0; tendon < 2; ++tendon) {
      auto record = record_of(tendon, 4);
      record.sequence = 7;
      const auto part = std::span(file).subspan(16 + tendon * tendon_bytes, tendon_bytes);
      lifemodel::ByteWriter(part).u32(tendon == 0 ? 1 : 3);
      std::ranges::copy(former_bytes(record), part.begin() + 4);
      if (schema == 2) {
        lifemodel::ByteWriter(part.subspan(68)).u32(84);
      }
      std::ranges::copy(block_of(8).bytes(), part.subspan(block_at).begin());
    }
    const auto covered = std::span(std::as_const(file)).first(file.size() - 4);
    lifemodel::ByteWriter(std::span(file).last(4)).u32(lifemodel::crc32(covered));
    const auto* const chars = reinterpret_cast<const char*>(file.data());
    folder_.write("life", {chars, chars + file.size()});
    auto without = record_of(1, 4);
    without.history = {};
    {
      Store store = opened(folder_);
      EXPECT_TRUE(store.notices().empty());
      EXPECT_EQ(store.sequence(), 7u);
      EXPECT_TRUE(same_life(*store.load(1), without));
      EXPECT_FALSE(store.load_parameters(0));
      EXPECT_EQ(store.load_parameters(1), block_of(8));
      EXPECT_EQ(store.save_parameters(0, block_of(9, 616)), Error::none);
    }
    Store store = opened(folder_);
    EXPECT_EQ(store.load_parameters(0), block_of(9, 616));
    EXPECT_EQ(store.load_parameters(1), block_of(8));
    EXPECT_TRUE(same_life(*store.load(1), without));
    EXPECT_EQ(store.save(records_of<2>(5)), Error::none);
    EXPECT_TRUE(same_life(*store.load(1), record_of(1, 5)));
  }
}

TEST_F(FileStore, AnEntryThatWasCutIsIgnoredAndReplaced) {
  const auto whole = folder_.read("authority.log");
  ASSERT_EQ(whole.size(), 48u);
  for (std::size_t size = 25; size < 48; ++size) {
    folder_.write("authority.log", {whole.begin(), whole.begin() + static_cast<int>(size)});
    {
      Store store = opened(folder_);
      EXPECT_TRUE(store.log(0));
      EXPECT_FALSE(store.log(1));
      ASSERT_EQ(store.notices().size(), 1u);
      EXPECT_EQ(store.notices()[0].path, folder_.file("authority.log"));
      ASSERT_EQ(store.append(entry_of(3)), Error::none);
    }
    const Store store = opened(folder_);
    EXPECT_TRUE(store.notices().empty());
    EXPECT_EQ(store.log(1)->detail, entry_of(3).detail);
    EXPECT_FALSE(store.log(2));
  }
}

TEST_F(FileStore, ADamagedEntryIsPassedOverAndStays) {
  folder_.flip("authority.log", 10);
  Store store = opened(folder_);
  ASSERT_EQ(store.notices().size(), 1u);
  EXPECT_NE(store.notices()[0].what.find("entry 0 is damaged"), std::string::npos);
  EXPECT_EQ(store.log(0)->detail, entry_of(2).detail);
  ASSERT_EQ(store.append(entry_of(3)), Error::none);
  EXPECT_EQ(folder_.read("authority.log").size(), 72u);
}

TEST_F(FileStore, ALinkInPlaceOfAFileIsNotFollowed) {
  std::filesystem::create_symlink(folder_.file("elsewhere"), folder_.file("life.partial"));
  Store store = opened(folder_);
  EXPECT_EQ(store.save(records_of<2>(4)), Error::failed);
  ASSERT_TRUE(store.problem());
  EXPECT_EQ(store.problem()->path, folder_.file("life.partial"));
  EXPECT_FALSE(folder_.has("elsewhere"));
}

}  // namespace
}  // namespace storage_test
