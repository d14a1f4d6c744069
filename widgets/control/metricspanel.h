// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/kepttrial.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace mb {

/// What was measured of A and B, what has changed, and in words and shape whether that is better; below it the state of the
/// loop in trial B as chips.
class MetricsPanel : public QWidget {
    Q_OBJECT
public:
    explicit MetricsPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Stands below everything else.
    void append(QWidget *below);
    /// nullptr: none.
    void setTrials(const KeptTrial *a, const KeptTrial *b);
    [[nodiscard]] QTableWidget &table() { return *m_table; }
    [[nodiscard]] QStringList chips() const { return m_chipTexts; }

private:
    void fill();
    void fillRow(int row, std::string_view key);
    void setCell(int row, int column, const QString &text, Tone tone, bool strong);
    void fillChips();
    void addChip(const QString &text, Tone tone, const QString &tip);
    void fit();

    const ThemeSource &m_theme;
    QLabel *m_repeats = nullptr;
    QTableWidget *m_table = nullptr;
    QLabel *m_health = nullptr;
    QWidget *m_chips = nullptr;
    QStringList m_chipTexts;
    std::optional<KeptTrial> m_a; ///< without signals
    std::optional<KeptTrial> m_b;
};

} // namespace mb
