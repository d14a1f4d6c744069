// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <optional>
#include <vector>

namespace mb {

/// One row of widgets that continues on the next line where it does not fit, so that nothing is cut at large fonts.
/// Widgets added after the spring stand at the right end of the first line while all fit into it.
class WrapLayout : public QLayout {
    Q_OBJECT
public:
    explicit WrapLayout(QWidget *parent = nullptr);
    ~WrapLayout() override;

    /// Between the lines; what is between the widgets, if none was given.
    void setLineSpacing(int spacing) { m_lineSpacing = spacing; }
    /// What follows goes to the right end.
    void addSpring() { m_spring = count(); }
    /// Before the others; what follows the spring stays what it is.
    void prepend(QWidget *widget);
    /// Takes what its line has to spare, and is as narrow as it may be before the line is broken.
    void setStretched(QWidget *widget) { m_stretched = widget; }

    void addItem(QLayoutItem *item) override { m_items.push_back(item); }
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem *itemAt(int index) const override;
    QLayoutItem *takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    void setGeometry(const QRect &rect) override;

private:
    struct Line {
        std::vector<int> items;
        int width = 0;
        int height = 0;
    };
    [[nodiscard]] std::vector<Line> linesFor(int width) const;
    void placeLine(const Line &line, const QRect &room, bool sprung) const;
    [[nodiscard]] QSize sizeOf(QLayoutItem &item) const;
    [[nodiscard]] int gap() const;
    [[nodiscard]] int lineGap() const { return m_lineSpacing.value_or(gap()); }

    std::vector<QLayoutItem *> m_items;
    int m_spring = -1;
    QWidget *m_stretched = nullptr;
    std::optional<int> m_lineSpacing;
};

} // namespace mb
