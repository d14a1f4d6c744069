// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace mb::abstractdc {

/// What a position tells of a restart, for which a drive has no word (README.md#restarts).
enum class Restart {
    No,
    Maybe, ///< near 0 after a silence, or where it was not before: it may have lost its power, or its cable was out or it turned
    Proven, ///< near 0 after a silence with its line open, and it had stood far from there: so it has lost its power
    Seen,   ///< near 0 while it answers, and no shaft gets there so fast
};

/// Judges that, here and nowhere else, from where a drive was and where it is. Engine thread.
class RestartSense {
public:
    /// Counts, between switching on and the first question.
    static constexpr std::int64_t turnedByHand = 100;
    /// Counts that its shaft has to be away from 0, for its power to be missed surely.
    static constexpr std::int64_t provesPower = 300;

    /// It does not answer any more; `position`, in counts, was the last that it told, and it `stood` there.
    void silent(bool lineOpen, std::optional<std::int64_t> position, bool stood);
    /// The first position that it tells after that, also after its line was gone or before this program ran; No of all others.
    /// `kept`: where an earlier run of the program saw it stand last.
    [[nodiscard]] Restart heard(std::int32_t position, std::optional<std::int64_t> kept = std::nullopt);
    /// Seen or No: from one position to the next one, between which a shaft gets no farther than `reach`.
    [[nodiscard]] static Restart between(double before, double position, double reach);

private:
    struct Place {
        std::int64_t position = 0;
        bool stood = false;
    };
    bool m_wasUnheard = true; ///< since it was heard last, or never heard
    bool m_wasSilent = false; ///< the same, while its line was open: it is off, or its cable is out
    std::optional<Place> m_before;
};

} // namespace mb::abstractdc
