#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "cli/output_file.h"

namespace fourwis
{
namespace
{

namespace fs = std::filesystem;

std::string content_of(const fs::path& path)
{
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// An empty directory, gone afterwards.
class OutputFileTest : public testing::Test
{
protected:
  OutputFileTest() { fs::create_directory(directory_); }
  ~OutputFileTest() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  long files() const { return std::distance(fs::directory_iterator(directory_), {}); }

  std::string name_ = testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path directory_ = fs::path(testing::TempDir()) / ("fourwis_output_" + name_);
};

TEST_F(OutputFileTest, AppearsAsAWholeOnCommit)
{
  {
    OutputFile file(path("plan.json"));
    file.stream() << "whole";
    EXPECT_FALSE(fs::exists(path("plan.json")));
    file.commit();
    EXPECT_EQ(content_of(path("plan.json")), "whole");
  }
  EXPECT_EQ(content_of(path("plan.json")), "whole");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WithoutCommitLeavesWhatWasThere)
{
  std::ofstream(path("old")) << "old";
  {
    OutputFile replacement(path("old")), fresh(path("new"));
    replacement.stream() << "half";
    fresh.stream() << "half";
  }
  EXPECT_EQ(content_of(path("old")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, CommitReplacesWhatWasThere)
{
  std::ofstream(path("old")) << "something longer than the new";
  OutputFile file(path("old"));
  file.stream() << "new";
  file.commit();
  EXPECT_EQ(content_of(path("old")), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WritesThroughASymbolicLink)
{
  std::ofstream(path("file")) << "old";
  fs::create_symlink(path("file"), path("link"));
  OutputFile file(path("link"));
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content_of(path("file")), "new");
}

TEST_F(OutputFileTest, DeviceStaysADevice)
{
  OutputFile file("/dev/null");
  file.stream() << "gone";
  file.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

void expect_rejection(const std::string& path)
{
  try
  {
    OutputFile file(path);
    ADD_FAILURE() << path << " was opened";
  }
  catch (const OutputError& error)
  {
    EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
  }
}

TEST_F(OutputFileTest, PlacesThatCannotBeWrittenAreRefusedByName)
{
  std::ofstream(path("file")) << "a file";
  expect_rejection(path("missing_directory/plan.json"));
  expect_rejection(path("file/plan.json"));
  expect_rejection(directory_.string());
}

TEST_F(OutputFileTest, FullDiskIsReportedByName)
{
  OutputFile file("/dev/full");
  file.stream() << std::string(100000, 'x');
  try
  {
    file.commit();
    ADD_FAILURE() << "was written";
  }
  catch (const OutputError& error)
  {
    EXPECT_EQ(std::string(error.what()).find("/dev/full: "), 0u) << error.what();
  }
}

TEST_F(OutputFileTest, DashIsTheStandardOutputWhereThatIsGiven)
{
  std::ostringstream standard_output;
  OutputFile file("-", &standard_output);
  file.stream() << "text";
  file.commit();
  EXPECT_EQ(standard_output.str(), "text");
}

}  // namespace
}  // namespace fourwis
