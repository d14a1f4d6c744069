// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/progress.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <map>
#include <optional>
#include <vector>

namespace mb {

/// One cell per flash page in the order they are written; the one that must not be interrupted is outlined in
/// danger until it is written.
class PageMap : public QWidget {
    Q_OBJECT
public:
    explicit PageMap(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Cells in writing order, and which of them is critical.
    void setParts(std::vector<int> parts, std::optional<int> critical);
    void setStates(const std::map<int, PartState> &states);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *) override { setMinimumHeight(heightForWidth(width())); }
    bool event(QEvent *event) override;

private:
    [[nodiscard]] int columns(int width) const;
    [[nodiscard]] QRectF cell(std::size_t place) const;
    [[nodiscard]] PartState stateOf(int part) const;
    /// What is written cannot be cut any more.
    [[nodiscard]] bool mustNotCut(int part) const { return part == m_critical && stateOf(part) != PartState::Done; }
    void paintCell(QPainter &painter, std::size_t place) const;
    [[nodiscard]] QString word(int part) const;

    const ThemeSource &m_theme;
    std::vector<int> m_parts;
    std::optional<int> m_critical;
    std::map<int, PartState> m_states;
    std::map<int, bool> m_repeated;
};

} // namespace mb
