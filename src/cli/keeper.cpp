#include "rt/cli/keeper.h"

#include <fmt/format.h>

#include <stdexcept>

#include "rt/cli/say.h"
#include "rt/io/whole_file.h"
#include "rt/scene/error.h"

namespace rt::cli {
namespace fs = std::filesystem;
namespace {

/// As a shell takes it for one word.
std::string quoted(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) {
    return word;
  }
  std::string text = "'";
  for (const char c : word) {
    text += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return text + "'";
}

}  // namespace

/// Finds the checkpoint, once the first picture's name is known.
void Keeper::open() {
  file_ = line_.checkpoint_file;
  if (file_.empty()) {
    file_ = picture_;
    file_ += ".checkpoint";
  }
  std::error_code error;
  const bool there = fs::exists(file_, error);
  if (there && line_.resume) {
    earlier_ = read_checkpoint(file_);
    own_.insert(file_);
  } else if (there) {
    warn(fmt::format("{} is of a run that was interrupted; --resume would go on from there",
                     file_.string()));
  } else if (line_.resume) {
    warn(fmt::format("--resume: there is no {}; all begins anew", file_.string()));
  }
}

Facts Keeper::facts_of_run_now() {
  if (done_.run.empty()) {
    done_.run = facts_of_run(line_);
  }
  Facts facts = done_.run;
  for (Fact& fact : files_.facts()) {
    facts.push_back(std::move(fact));
  }
  return facts;
}

void Keeper::check(const Facts& options, const Facts& then) {
  std::string difference = first_difference(facts_of_run_now(), earlier_->run);
  if (difference.empty()) {
    difference = first_difference(options, then);
  }
  if (!difference.empty()) {
    throw FileError(
        fmt::format("cannot resume from {}: it is of another run: {}; make them the same, or leave "
                    "--resume out and begin anew",
                    file_.string(), difference));
  }
}

bool Keeper::begin(const fs::path& picture, const RenderOptions& options, const Crop& crop) {
  picture_ = picture;
  options_ = facts_of_options(options, crop);
  options_.insert(options_.begin(), {"the picture", picture.string()});
  if (file_.empty()) {
    open();
  }
  const std::size_t index = done_.finished.size();
  if (!earlier_ || index >= earlier_->finished.size()) {
    return false;
  }
  const Checkpoint::Finished& then = earlier_->finished[index];
  check(options_, then.options);
  if (then.digest == 0 || digest_of_file(picture) != then.digest) {  // 0: it could not be read
    warn(fmt::format("{} has changed or gone since it was finished, and is rendered again",
                     picture.string()));
    return false;
  }
  done_.finished.push_back(then);
  return true;
}

void Keeper::take_up(Rendering& rendering, const RenderJob& job) {
  if (!earlier_ || !earlier_->current || done_.finished.size() != earlier_->finished.size()) {
    return;
  }
  Facts now = options_;
  now.push_back(fact_of_scene(job));
  check(now, earlier_->current->options);
  try {
    ByteReader state(earlier_->state);
    rendering.load(state);
  } catch (const std::out_of_range&) {
    throw FileError(fmt::format("cannot resume from {}: it is damaged", file_.string()));
  }
  earlier_->current.reset();
  earlier_->state = {};
}

void Keeper::finished() {
  // Now, not when a signal comes: what the file is by then need not be what was rendered.
  done_.finished.push_back({picture_.string(), options_, digest_of_file(picture_)});
  if (!own_.empty() || line_.checkpoint_every > 0.0) {
    try {
      save(nullptr, nullptr);
    } catch (const FileError& error) {
      warn(error.what());
    }
  }
}

Saved Keeper::save(const Rendering* rendering, const RenderJob* job) {
  if (earlier_ && earlier_->current) {
    return {file_, {}};  // a later picture's state has not been taken up yet: it stays there
  }
  Checkpoint checkpoint{facts_of_run_now(), done_.finished, {}, {}};
  if (rendering != nullptr) {
    checkpoint.current = {picture_.string(), options_};
    checkpoint.current->options.push_back(fact_of_scene(*job));
  }
  const std::vector<unsigned char> bytes = encode(checkpoint, rendering);
  Saved saved =
      save_somewhere(file_, [&](const fs::path& path) { io::write_whole_file(path, bytes); });
  own_.insert(saved.path);
  return saved;
}

void Keeper::end() const {
  for (const fs::path& file : own_) {
    std::error_code ignored;
    fs::remove(file, ignored);
  }
}

std::string Keeper::command(const fs::path& checkpoint) const {
  std::string text;
  for (const std::string& word : line_.words) {
    text += quoted(word) + ' ';
  }
  text += line_.resume ? "" : "--resume ";
  if (checkpoint != file_) {
    text += "--checkpoint-file " + quoted(checkpoint.string()) + ' ';
  }
  if (!line_.arguments.empty()) {
    text += "-- ";
    for (const std::string& word : line_.arguments) {
      text += quoted(word) + ' ';
    }
  }
  text.pop_back();
  return text;
}

}  // namespace rt::cli
