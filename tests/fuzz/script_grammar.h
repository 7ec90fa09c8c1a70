#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// Scripts that are mostly right: every choice in them is made by a byte of `seed`.
class ScriptGrammar {
 public:
  explicit ScriptGrammar(std::span<const std::uint8_t> seed) : seed_(seed) {}

  std::string script() {
    std::string text = "local n, m, l = {gr.node('root')}, {gr.material{kd = 1}}, {}\n";
    while (at_ < seed_.size() && text.size() < 4000) {
      text += statement() + "\n";
    }
    return text;
  }

 private:
  unsigned choose(unsigned choices) { return at_ < seed_.size() ? seed_[at_++] % choices : 0; }

  std::string number() {
    static const char* const numbers[] = {
        "0",    "1",  "-1",  "0.5", "2",   "1e300", "-1e300", "1e-9",    "0/0",   "1/0",
        "3.75", "90", "640", "'4'", "nil", "1e16",  "true",   "-1e-320", "65536", "2^53"};
    return numbers[choose(std::size(numbers))];
  }
  std::string triple() {
    static const char* const odd[] = {"{}", "nil", "{1, 2}", "{1, 2, 3, 4}", "5", "'red'", "{{}}"};
    return choose(8) == 0 ? odd[choose(std::size(odd))]
                          : "{" + number() + ", " + number() + ", " + number() + "}";
  }
  std::string node() { return "n[" + std::to_string(choose(6)) + " % #n + 1]"; }
  std::string name() {
    static const char* const names[] = {"'a'", "''", "'x\\0y'", "5", "('long'):rep(50)", "nil"};
    return names[choose(3) == 0 ? choose(std::size(names)) : 0];
  }

  std::string shape() {
    switch (choose(10)) {
      case 0:
        return "gr.nh_sphere(" + name() + ", " + triple() + ", " + number() + ")";
      case 1:
        return "gr.nh_box(" + name() + ", " + triple() + ", " + number() + ")";
      case 2:
        return "gr.torus(" + name() + ", " + number() + ", " + number() + ")";
      case 3:
        return "gr.mesh(" + name() + ", {" + triple() + ", " + triple() + ", " + triple() +
               "}, {{0, 1, " + number() + "}})";
      case 4:
        return "gr.joint(" + name() + ", " + triple() + ", " + triple() + ")";
      case 5:
        return "gr.plane(" + name() + ", " + number() + ")";
      default:
        static const char* const plain[] = {"sphere",  "cube", "cylinder", "cone",
                                            "capsule", "blob", "node"};
        return std::string("gr.") + plain[choose(std::size(plain))] + "(" + name() + ")";
    }
  }

  std::string statement() {
    switch (choose(10)) {
      case 0:
      case 1:
        return "n[#n + 1] = " + shape();
      case 2:
        return node() + ":add_child(" + node() + ")";
      case 3:
        return node() + ":translate(" + number() + ", " + number() + ", " + number() + ")";
      case 4:
        return node() + ":rotate('" + "xyzXw"[choose(5)] + "', " + number() + ")";
      case 5:
        return node() + ":scale(" + number() + ", " + number() + ", " + number() + ")";
      case 6:
        return "m[1] = gr.material(" + triple() + ", " + triple() + ", " + number() + ", " +
               number() + ", " + number() + ") " + node() + ":set_material(m[1])";
      case 7:
        return "l[#l + 1] = gr.light(" + triple() + ", " + triple() + ", " + triple() + ", " +
               number() + ")";
      case 8:
        return "pcall(gr.render, " + node() + ", 'a.png', 8, 8, " + triple() + ", " + triple() +
               ", {0, 1, 0}, " + number() + ", " + triple() + ", l, {samples = " + number() + "})";
      default:
        static const char* const others[] = {
            "collectgarbage()",
            "n = {gr.node('new')}",
            "coroutine.wrap(function() n[9] = 1 end)()",
            "for i = 1, 20 do n[1]:add_child(gr.sphere('s')) end",
            "error(n)",
            "pcall(error, l)",
            "do local t = gr.node('t') t:add_child(n[1]) t:add_child(n[1]) n[1] = t end"};
        return others[choose(std::size(others))];
    }
  }

  std::span<const std::uint8_t> seed_;
  std::size_t at_ = 0;
};
