// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "tuning/adviser.h"
#include "widgets/common/theme.h"

#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

class QVBoxLayout;

namespace mb {

/// What an adviser found, with its number, for people.
[[nodiscard]] QString adviceText(const tuning::Advice &advice);
/// Each of these values (Advice::changes) by the name that its parameter has in the table: "Nominal forward = 819".
[[nodiscard]] QStringList remedyTexts(const Family &family, const std::vector<std::pair<std::string, double>> &changes);

/// "Why it did that": the two weightiest causes of a trial, each with its number and one button that stages what to try.
class AdvicePanel : public QWidget {
    Q_OBJECT
public:
    explicit AdvicePanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// nullptr: no trial.
    void setTrial(const Family *family, const tuning::Trial *trial);
    [[nodiscard]] const std::vector<tuning::Advice> &advice() const { return m_advice; }
    /// Seconds in which I went on while the duty was at its limit; nothing where it did not, or where that cannot be judged.
    [[nodiscard]] std::optional<double> windup() const { return m_windup; }

Q_SIGNALS:
    void stageRequested(const mb::tuning::Advice &advice);

private:
    void rebuild(const Family *family);

    const ThemeSource &m_theme;
    std::vector<tuning::Advice> m_advice;
    std::optional<double> m_windup;
    QVBoxLayout *m_column = nullptr;
};

} // namespace mb
