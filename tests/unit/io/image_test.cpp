#include "rt/io/image.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <thread>

#include "rt/io/encoding.h"
#include "rt/io/whole_file.h"
#include "rt/scene/error.h"
#include "temp_folder.h"

namespace rt::io {
namespace {

const std::map<std::string, std::string> metadata{{"Software", "raytracer 0.1.0"},
                                                  {"raytracer:seed", "17"},
                                                  {"raytracer:scene", "0123456789abcdef"}};

/// Smooth enough for JPEG, and different in every row, column and channel.
Image ramp(int width = 40, int height = 24) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels.push_back(static_cast<float>(x) / static_cast<float>(width));
      image.pixels.push_back(static_cast<float>(y) / static_cast<float>(height));
      image.pixels.push_back(0.25F);
    }
  }
  return image;
}

class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, ComeBackAsWritten) {
  const TempFolder folder;
  const auto file = folder / (std::string("picture") + GetParam());
  const Image image = ramp();
  for (const auto encoding : {Encoding::srgb, Encoding::raw}) {
    write_image(file, image, encoding, metadata);
    const Image back = read_image(file);
    ASSERT_EQ(back.width, image.width);
    ASSERT_EQ(back.height, image.height);
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    const std::string extension = GetParam();
    const bool is_exr = extension == ".exr" || extension == ".EXR";
    const float tolerance =
        extension.find_first_of("jJ") != std::string::npos ? 6.0F / 255.0F : 0.0F;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const float expected = is_exr
                                 ? image.pixels[i]
                                 : static_cast<float>(encode8(image.pixels[i], encoding)) / 255.0F;
      ASSERT_NEAR(back.pixels[i], expected, tolerance + 1e-6F) << GetParam() << " value " << i;
    }
  }
  EXPECT_EQ(folder.entries(), 1U);
}

TEST_P(Formats, WriteOnePixel) {
  const TempFolder folder;
  const auto file = folder / (std::string("dot") + GetParam());
  write_image(file, {1, 1, {1.0F, 1.0F, 1.0F}}, Encoding::srgb, {});
  EXPECT_NEAR(read_image(file).pixels.at(0), 1.0F, 1e-6F);
}

INSTANTIATE_TEST_SUITE_P(All, Formats,
                         testing::Values(".png", ".bmp", ".tga", ".jpg", ".jpeg", ".exr", ".PNG",
                                         ".Jpg", ".EXR"),
                         [](const auto& instance) {
                           return std::to_string(instance.index) + "_" + (instance.param + 1);
                         });

TEST(WriteImage, GivesEqualBytesForEqualInputs) {
  const TempFolder folder;
  const Image image = ramp();
  const std::vector<std::string> extensions{".png", ".bmp", ".tga", ".jpg", ".exr"};
  for (const auto& extension : extensions) {
    write_image(folder / ("a" + extension), image, Encoding::srgb, metadata);
  }
  // A second later, so that a date would show; under another name, so that a name would, too.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  for (const auto& extension : extensions) {
    write_image(folder / ("other" + extension), image, Encoding::srgb, metadata);
    EXPECT_EQ(bytes_of(folder / ("a" + extension)), bytes_of(folder / ("other" + extension)))
        << extension;
  }
}

TEST(WriteImage, CarriesTheMetadataAndNoDate) {
  const TempFolder folder;
  for (const std::string name : {"a.png", "a.exr"}) {
    write_image(folder / name, ramp(), Encoding::srgb, metadata);
    const std::string bytes = bytes_of(folder / name);
    for (const auto& [key, value] : metadata) {
      EXPECT_NE(bytes.find(value), std::string::npos) << name << " lacks " << key;
    }
    for (const char* trace : {"tIME", "capDate", "DateTime", "OpenImageIO", "HostComputer"}) {
      EXPECT_EQ(bytes.find(trace), std::string::npos) << name << " has " << trace;
    }
  }
}

TEST(WriteImage, KeepsFloatsExactlyInExr) {
  const TempFolder folder;
  const float tiny = std::numeric_limits<float>::denorm_min();
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image{2, 1, {1e-30F, 123456.789F, -2.5F, tiny, infinity, std::nanf("")}};
  write_image(folder / "a.exr", image, Encoding::srgb, {});
  const Image back = read_image(folder / "a.exr");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(back.pixels[i], image.pixels[i]);
  }
  EXPECT_TRUE(std::isnan(back.pixels[5]));
}

TEST(WriteImage, SurvivesNaN) {
  const TempFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  write_image(folder / "a.png", {1, 1, {std::nanf(""), infinity, -infinity}}, Encoding::srgb, {});
  EXPECT_EQ(read_image(folder / "a.png").pixels, (std::vector<float>{0.0F, 1.0F, 0.0F}));
}

TEST(WriteImage, RefusesAnotherExtension) {
  const TempFolder folder;
  for (const char* name : {"a.gif", "a", "a.png.txt", ".png", "a.", ""}) {
    const auto message = message_of<FileError>([&] { check_output(folder / name, 1, 1); });
    EXPECT_NE(message.find(".png, .bmp"), std::string::npos) << message;
  }
  EXPECT_NO_THROW(check_output(folder / "a.TGA", 1, 1));
}

TEST(WriteImage, RefusesASizeThatTheFormatCannotHold) {
  const TempFolder folder;
  EXPECT_NO_THROW(check_output(folder / "a.tga", 65535, 1));
  EXPECT_THROW(check_output(folder / "a.tga", 65536, 1), FileError);
  EXPECT_THROW(check_output(folder / "a.jpg", 1, 65501), FileError);
  EXPECT_NO_THROW(check_output(folder / "a.exr", 70000, 10));
}

TEST(WriteImage, NamesTheMissingFolder) {
  const TempFolder folder;
  const auto file = folder / "missing" / "a.png";
  for (const auto& message : {message_of<FileError>([&] { check_output(file, 1, 1); }),
                              message_of<FileError>([&] { write_image(file, ramp(), {}, {}); })}) {
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    EXPECT_NE(message.find("create"), std::string::npos) << message;
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(WriteImage, RefusesAFolderAsFile) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "a.png");
  EXPECT_THROW(check_output(folder / "a.png", 1, 1), FileError);
  EXPECT_THROW(write_image(folder / "a.png", ramp(), {}, {}), FileError);
  EXPECT_EQ(folder.entries(), 1U);
}

/// Runs the checks in a child process: without root's rights, or with a limit, that the parent
/// keeps clear of. The child's exit code is the number of the check that failed.
template <typename F>
int in_child(F checks) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(checks());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 100 + WTERMSIG(status);
}

TEST(WriteImage, RefusesAReadOnlyFolder) {
  const TempFolder folder;
  ::chmod(folder.path().c_str(), 0555);
  const int failed = in_child([&] {
    if (::geteuid() == 0 && ::setresuid(65534, 65534, 65534) != 0) {
      return 1;
    }
    try {
      check_output(folder / "a.png", 1, 1);
      return 2;
    } catch (const FileError& error) {
      if (std::string(error.what()).find("Permission denied") == std::string::npos) {
        return 3;
      }
    }
    try {
      write_whole_file(folder / "a.png", {});
      return 4;
    } catch (const FileError&) {
      return 0;
    }
  });
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(WriteImage, LeavesNoHalfFileOnAFullDisk) {
  const TempFolder folder;
  put(folder / "a.bmp", "the old one");
  const std::vector<unsigned char> bytes(100000, 'x');
  // A limit on file sizes fails in write() just where a full disk does.
  const int failed = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) {
      return 1;
    }
    try {
      write_whole_file(folder / "a.bmp", bytes);
      return 2;
    } catch (const FileError& error) {
      return std::string(error.what()).find("a.bmp") == std::string::npos ? 3 : 0;
    }
  });
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(bytes_of(folder / "a.bmp"), "the old one");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(WriteImage, LeavesTheOldOrTheNewFileWhenKilled) {
  const TempFolder folder;
  const std::string old(300000, 'o');
  const std::vector<unsigned char> bytes(300000, 'n');
  for (int delay = 0; delay < 40; ++delay) {
    put(folder / "a.bmp", old);
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) {
        write_whole_file(folder / "a.bmp", bytes);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100 * delay));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string left = bytes_of(folder / "a.bmp");
    EXPECT_TRUE(left == old || left == std::string(300000, 'n'));
  }
}

TEST(WriteImage, ReplacesAnOldFileAndStepsOverStrayTemporaries) {
  const TempFolder folder;
  put(folder / "a.png", "old");
  for (int i = 0; i < 20; ++i) {  // as a killed process with our number would leave them
    put(folder / (".raytracer-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp"),
        "stray");
  }
  write_image(folder / "a.png", ramp(), Encoding::srgb, {});
  EXPECT_EQ(read_image(folder / "a.png").width, 40);
  EXPECT_EQ(folder.entries(), 21U);
}

TEST(WriteImage, WorksFromSeveralThreads) {
  const TempFolder folder;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      preload();
      write_image(folder / (std::to_string(i) + ".png"), ramp(), Encoding::srgb, metadata);
    });
  }
  threads.clear();
  EXPECT_EQ(bytes_of(folder / "0.png"), bytes_of(folder / "3.png"));
}

TEST(ReadImage, TrustsTheContentAndNotTheName) {
  const TempFolder folder;
  write_image(folder / "a.png", ramp(), Encoding::srgb, {});
  std::filesystem::copy_file(folder / "a.png", folder / "b.exr");
  EXPECT_EQ(read_image(folder / "b.exr").pixels, read_image(folder / "a.png").pixels);
}

TEST(ReadImage, NamesWhatItCannotRead) {
  const TempFolder folder;
  put(folder / "text.png", "this is no picture");
  put(folder / "empty.png", "");
  put(folder / "short.png", "\x89PNG\r\n\x1a\n");
  put(folder / "noise.tga", std::string(1000, '\xa7'));
  std::filesystem::create_directory(folder / "folder.png");
  for (const char* name :
       {"text.png", "empty.png", "short.png", "noise.tga", "folder.png", "missing.png"}) {
    const auto message = message_of<FileError>([&] { read_image(folder / name); });
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

TEST(ReadImage, ChecksTheClaimedSizeBeforeTheMemory) {
  const TempFolder folder;
  write_image(folder / "a.tga", ramp(), Encoding::srgb, {});
  std::string bytes = bytes_of(folder / "a.tga");
  bytes.replace(12, 4, "\xff\xff\xff\xff");  // width and height
  put(folder / "a.tga", bytes);
  const auto message = message_of<FileError>([&] { read_image(folder / "a.tga"); });
  EXPECT_NE(message.find("65535"), std::string::npos) << message;
}

/// A process that ends while the formats are still loading must end cleanly.
TEST(Preload, LetsTheProcessExitAtOnce) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        preload();
        std::exit(7);
      },
      testing::ExitedWithCode(7), "^$");
}

}  // namespace
}  // namespace rt::io
