// The gate: what headers claim, and which files are refused before a decoder sees them.
#include "rt/io/texture_header.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>

#include "picture_bytes.h"
#include "rt/scene/error.h"
#include "temp_folder.h"

namespace rt::io {
namespace {

class Gate : public testing::Test {
 protected:
  PictureHeader header(const std::string& content, const std::string& name = "picture") {
    put(folder_ / name, content);
    return check_picture(PictureFile(folder_ / name), limits_);
  }
  std::string refusal(const std::string& content, const std::string& name = "picture") {
    const std::string message = message_of<FileError>([&] { header(content, name); });
    EXPECT_NE(message.find((folder_ / name).string()), std::string::npos) << message;
    return message;
  }
  void expect_refused(const std::string& content, const std::string& words,
                      const std::string& name = "picture") {
    const std::string message = refusal(content, name);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
  static void expect_claims(const PictureHeader& h, const std::string& format, std::uint64_t width,
                            std::uint64_t height, std::uint64_t channels) {
    EXPECT_EQ(h.format, format);
    EXPECT_EQ(h.width, width);
    EXPECT_EQ(h.height, height);
    EXPECT_EQ(h.channels, channels);
  }

  TempFolder folder_;
  TextureLimits limits_;
};

/// A JPEG of 12 x 13 pixels up to its scan's data.
std::string jpeg_start() {
  return bytes({0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0, 0xff, 0xff, 0xc0, 0, 17, 8}) + be(13, 2) +
         be(12, 2) + bytes({4}) + std::string(9, 'a');
}

TEST_F(Gate, ReadsWhatEachFormatClaims) {
  expect_claims(header(png(2, 16, 2, {std::string(12, 'a')})), "PNG", 2, 1, 3);
  expect_claims(header(bmp(3, 2, std::string(24, 'a'))), "BMP", 3, 2, 3);
  expect_claims(header(tga(5, 4, 24, std::string(60, 'a')), "a.TGA"), "TGA", 5, 4, 4);
  expect_claims(header(hdr("-Y 7 +X 6", "")), "HDR", 6, 7, 3);
  expect_claims(header(tiff({{256, 9}, {257, 8}, {258, 8}, {277, 3}}, "")), "TIFF", 9, 8, 3);
  expect_claims(header(exr_header(10, 11)), "EXR", 11, 12, 1);
  expect_claims(header(jpeg_start() + bytes({0xff, 0xd9})), "JPEG", 12, 13, 4);
}

TEST_F(Gate, CountsChannelsAndBytes) {
  EXPECT_EQ(header(png(1, 8, 0, {"a"})).channels, 1U);
  EXPECT_EQ(header(png(1, 8, 4, {"aa"})).channels, 2U);
  EXPECT_EQ(header(png(1, 16, 6, {"aaaaaaaa"})).channel_bytes, 2U);
  EXPECT_EQ(header(hdr("-Y 7 +X 6", "")).channel_bytes, 4U);
}

TEST_F(Gate, RefusesWhatIsNoFileToRead) {
  const auto refused = [&](const std::string& name) {
    return message_of<FileError>([&] { const PictureFile file(folder_ / name); });
  };
  EXPECT_NE(refused("none.png").find("No such file"), std::string::npos);
  std::filesystem::create_directory(folder_ / "folder.png");
  EXPECT_NE(refused("folder.png").find("a folder"), std::string::npos);
  ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  EXPECT_NE(refused("pipe.png").find("not a regular file"), std::string::npos);
  std::filesystem::create_symlink("/dev/zero", folder_ / "device.png");
  EXPECT_NE(refused("device.png").find("not a regular file"), std::string::npos);
  put(folder_ / "empty.png", "");
  EXPECT_NE(refused("empty.png").find("empty"), std::string::npos);
}

TEST_F(Gate, RefusesWhatIsNotOnTheList) {
  const std::string list = "PNG, JPEG, BMP, TGA, TIFF, EXR or HDR";
  expect_refused("hello, world: this is no picture", list, "text.png");
  expect_refused("GIF89a" + std::string(20, '\1'), "GIF; save it as PNG", "moving.png");
  expect_refused("P6 2 2 255\nabcdefghijkl", list, "plain.ppm");
  expect_refused(std::string("\0\0\1\0", 4) + std::string(30, '\0'), list, "icon.bmp");
  expect_refused("P", list);
  expect_refused(tga(5, 4, 24, std::string(60, 'a')), list, "no_name_of_a_tga.png");
}

TEST_F(Gate, GoesByWhatTheFileHolds) {
  EXPECT_STREQ(header(bmp(3, 2, std::string(24, 'a')), "a.png").reader, "bmp");
  EXPECT_STREQ(header(png(1, 8, 0, {"a"}), "a.tga").reader, "png");
}

TEST_F(Gate, RefusesEmptyPictures) {
  const std::string words = "claims 0 x 0";
  expect_refused(png_start(0, 0, 8, 2), words);
  expect_refused(bmp(0, 0, ""), words);
  expect_refused(tga(0, 0, 24, ""), words, "a.tga");
  expect_refused(hdr("-Y 0 +X 0", ""), words);
  expect_refused(hdr("nothing of the kind", ""), words);
  expect_refused(tiff({{256, 0}, {257, 0}, {258, 8}}, ""), words);
  expect_refused(exr_header(-1, -1), words);
}

TEST_F(Gate, RefusesBombsOfEveryFormat) {
  const std::string words = "but at most 16384 a side";
  expect_refused(png_bomb(60'000), words);
  expect_refused(png_bomb(0xffff'ffff), words);
  expect_refused(bmp(0x8000'0000, 0x7fff'ffff, ""), words);
  expect_refused(tga(60'000, 60'000, 24, ""), words, "a.tga");
  expect_refused(hdr("-Y 99999999999999999999 +X 60000", ""), "claims");
  expect_refused(tiff({{256, 60'000}, {257, 60'000}, {258, 8}, {277, 3}}, ""), words);
  expect_refused(exr_header(0x7fff'ffff, 0x7fff'ffff), words);
  // 65535 x 65535 is the most that JPEG can say.
  expect_refused(bytes({0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0xff, 0xff, 0xff, 0xff, 3}) +
                     std::string(9, 'a') + bytes({0xff, 0xd9}),
                 words);
}

TEST_F(Gate, RefusesWhatWouldDecodeToTooMuch) {
  // 16384 x 16384 x 4 channels of 2 bytes: 2 GB.
  expect_refused(png_start(16384, 16384, 16, 6), "more than 1024 MB");
  limits_.decoded_bytes = 5;
  expect_refused(png(1, 16, 2, {"aaaaaa"}), "more than");
  limits_.decoded_bytes = 6;
  EXPECT_NO_THROW(header(png(1, 16, 2, {"aaaaaa"})));
}

TEST_F(Gate, KeepsToTheGivenSide) {
  limits_.largest_side = 2;
  EXPECT_NO_THROW(header(bmp(2, 2, std::string(16, 'a'))));
  expect_refused(bmp(3, 2, std::string(24, 'a')), "at most 2 a side");
}

TEST_F(Gate, RefusesFilesThatCannotHoldTheirPixels) {
  const std::string words = "cut short";
  expect_refused(png_bomb(16'000), words);
  expect_refused(bmp(3, 2, std::string(23, 'a')), words);
  expect_refused(tga(5, 4, 24, std::string(59, 'a')), words, "a.tga");
  // What is read of each: a PNG's checksum is not, nor where TIFF's next list would be.
  for (const std::string& needed :
       {png_start(1, 1, 8, 0).substr(0, 26), bmp(3, 2, ""), hdr("-Y 7 +X 6", ""),
        tiff({{256, 9}, {257, 8}, {258, 8}}, "").substr(0, 46), exr_header(10, 11)}) {
    for (std::size_t size = 11; size < needed.size(); ++size) {
      refusal(needed.substr(0, size));
    }
  }
}

TEST_F(Gate, RefusesWhatReadersHaveGotWrong) {
  constexpr std::uint32_t run_lengths = 1;
  expect_refused(bmp(3, 2, std::string(24, 'a'), run_lengths), "compressed BMP");
  // A TGA's footer is not shown to the reader.
  const std::string body = tga(1, 1, 24, "abc");
  const PictureHeader h =
      header(body + std::string(8, '\xff') + std::string("TRUEVISION-XFILE.\0", 18), "a.png");
  EXPECT_STREQ(h.reader, "targa");
  EXPECT_EQ(h.readable_bytes, body.size());
}

TEST_F(Gate, FindsTheEndOfAJpegWhereverItIs) {
  // Around the end of what is read at a time, 16 KB.
  for (std::size_t before = 16'370; before < 16'395; ++before) {
    const std::string data = jpeg_start() + std::string(before, 'a');
    EXPECT_EQ(header(data + bytes({0xff, 0xd9})).width, 12U) << before;
    EXPECT_EQ(header(data + bytes({0xff, 0xff, 0xd9}) + "tail").width, 12U) << before;
    expect_refused(data + bytes({0xff}), "have no end");
    expect_refused(data + bytes({0xff, 0, 0xd9}), "have no end");
    // Within a segment there are no marks, wherever its length stands.
    const std::string segment = bytes({0xff, 0xe1, 0, 4, 0xff, 0xd9});
    expect_refused(data + segment + "tail", "have no end");
    EXPECT_EQ(header(data + segment + bytes({0xff, 0xd9})).width, 12U) << before;
  }
}

TEST_F(Gate, IsQuickHoweverTheHeaderWinds) {
  // As many empty JPEG segments as there is patience for, and a TIFF list that never ends.
  std::string segments("\xff\xd8", 2);
  for (int i = 0; i < 1'000'000; ++i) {
    segments += std::string("\xff\xe0\0\2", 4);
  }
  const auto begin = std::chrono::steady_clock::now();
  expect_refused(segments, "JPEG header makes no sense");
  // A JPEG whose data are nothing but escaped bytes: its end is looked for.
  expect_refused(jpeg_start() + std::string(3'000'000, '\xff') + '\0', "have no end");
  std::string escapes = jpeg_start();
  for (int i = 0; i < 1'500'000; ++i) {
    escapes += std::string("\xff\0", 2);
  }
  expect_refused(escapes, "have no end");
  expect_refused(std::string("II*\0\x08\0\0\0\xff\xff", 10), "TIFF header makes no sense");
  expect_refused("#?RADIANCE\n" + std::string(1'000'000, 'a'), "its header makes no sense");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace
}  // namespace rt::io
