// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/setadviser.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <functional>
#include <vector>

class QFrame;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace mb {

/// What is to be known of the chosen set before it is written, one place for each property, also where all is well: its state in a shape and
/// a word, one sentence with the numbers, and one button where there is a value to stage.
class AdviserList : public QWidget {
    Q_OBJECT
public:
    explicit AdviserList(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Of this set, by name; `isStaged`: whether the values that an advice changes are staged already.
    void show(const tuning::ProposalBasis &basis, const tuning::Proposal &proposal, const QString &name,
        const std::vector<tuning::SetAdvice> &advice, const std::function<bool(const tuning::SetAdvice &)> &isStaged);
    /// There is no set.
    void clear();
    /// Where there is little room, what is in order has its words in its tooltip; where there is less, all of it takes one line.
    enum class Density : std::uint8_t { Comfortable, Compact, Dense };
    void setDensity(Density density);

Q_SIGNALS:
    /// Other places take more or less room.
    void rebuilt();
    /// To be staged, or no longer.
    void stageRequested(const mb::tuning::SetAdvice &advice, bool staged);

private:
    struct Place {
        tuning::SetAdvice advice;
        QString words;
        QString remedy; ///< the values that its button stages
        bool staged = false;
        friend bool operator==(const Place &, const Place &) = default;
    };
    void rebuild();
    void addPlace(const Place &place);
    void addSum();
    [[nodiscard]] QPushButton *stageButton(const Place &place, QWidget *box);

    const ThemeSource &m_theme;
    QLabel *m_of = nullptr;
    QVBoxLayout *m_rows = nullptr;
    QWidget *m_box = nullptr;
    std::vector<Place> m_places;
    Density m_density = Density::Comfortable;
    QWidget *m_sum = nullptr;      ///< the names of what is in order
    std::vector<QWidget *> m_fine; ///< what is in order
    std::vector<QLabel *> m_quiet; ///< words of what is in order, or was changed
    std::vector<QFrame *> m_lines;
};

/// "D noise", in front of people.
[[nodiscard]] QString placeText(tuning::Cause cause);
/// One sentence with the numbers.
[[nodiscard]] QString adviceText(
    const tuning::ProposalBasis &basis, const tuning::Proposal &proposal, const tuning::SetAdvice &advice);

} // namespace mb
