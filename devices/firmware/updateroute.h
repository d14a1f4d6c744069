// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace mb {

/// A schematic that goes with something that hands do: SVG, of which only widgets make a picture.
struct Drawing {
    int width = 0; ///< of its view box
    int height = 0;
    /// Elements of SVG, one over the other. `{outline}`, `{panel}`, `{control}`, `{canvas}`, `{text}`, `{dim}`, `{accent}`,
    /// `{onfill}`, `{ok}`, `{caution}` and `{danger}` stand for the colours of the theme, `{0}` … `{9}` for `words`.
    std::span<const std::string_view> layers{};
    std::span<const std::string_view> words{}; ///< English, marked for translation ("table")
    std::string_view description{};            ///< the same as a sentence, for who cannot see it; marked, too
};

/// Something that hands or the program do during an update, in the order of the work. The update reports each as a part of
/// its progress, numbered from 0.
struct GuidedStep {
    std::string_view title;
    std::string_view text;
    const Drawing *drawing = nullptr; ///< what the window shows with it; nullptr: none
};

/// What is not known of a way in, with what is likely; another value goes into `--via` as an option: `?key=value`.
struct UpdateSetting {
    std::string_view key;
    std::string_view label;
    std::string_view help;
    std::string_view fallback;
    std::span<const std::string_view> choices{}; ///< empty: any text
};

/// What the external program of a route can use, as that program calls it.
struct Programmer {
    enum class Port { None, Usb, Serial };
    std::string_view name;  ///< usbasp
    std::string_view title; ///< what people call it; a name, or English that widgets translate
    Port port = Port::None; ///< where it is plugged in, after another colon: nowhere to be told, `usb`, a serial port
};

/// What is said around an update: English literals, marked for translation ("table").
struct UpdateWords {
    std::string_view cancel{};   ///< what cancelling leaves, now that nothing fatal is written
    std::string_view written{};  ///< the same once pages were written; empty: the same
    std::string_view critical{}; ///< why it cannot be cancelled while Progress::mayInterrupt() is false
    std::string_view cut{};      ///< what losing the supply leaves, or the link …
    std::string_view fatalCut{}; ///< … while it must not; empty: the same
    std::string_view silent{}; ///< what helps a unit that answers nothing, behind "update it, or"; empty: nothing else
};

/// A way in for an update besides the device's own link: what `--via` is to name.
struct UpdateRoute {
    std::string_view scheme{};                   ///< before the first colon: openocd
    std::string_view example{};                  ///< openocd:stlink
    std::span<const std::string_view> targets{}; ///< of `--target`; empty: it needs none
    bool erasesSettings = false;                 ///< UpdateOptions::eraseSettings
    std::span<const GuidedStep> steps{};         ///< empty: it needs no hands
    std::span<const UpdateSetting> settings{};
    std::span<const Programmer> programmers{}; ///< the usual ones; others may be named, too
    UpdateWords words{};
};

} // namespace mb
