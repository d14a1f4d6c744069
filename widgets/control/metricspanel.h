// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <utility>

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
    /// nullptr: none. `windup`: seconds in which I went on at the limit in B; nothing where it did not.
    void setTrials(const KeptTrial *a, const KeptTrial *b, std::optional<double> windup = std::nullopt);
    /// For its names and words whole, without ± and numbers of the difference.
    [[nodiscard]] int leastWidth() const { return m_least; }
    [[nodiscard]] QTableWidget &table() { return *m_table; }
    [[nodiscard]] QStringList chips() const { return m_chipTexts; }

Q_SIGNALS:
    void leastWidthChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    /// What a row shows; where there is little room ± and the difference as a number give way to the tooltip, words and
    /// shape never, nor the ± that makes a difference none.
    enum class Detail { All, WithoutError, WordsOnly };

    void fill();
    void fillRows();
    void fillRow(int row, std::string_view key, Detail detail);
    [[nodiscard]] std::pair<QString, Tone> differenceOf(std::string_view key, Detail detail) const;
    [[nodiscard]] int widthOf(int column) const;
    [[nodiscard]] int tableWidth() const;
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
    int m_least = 0;
    std::optional<KeptTrial> m_a; ///< without signals
    std::optional<KeptTrial> m_b;
    std::optional<double> m_windup;
};

} // namespace mb
