// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/listcard.h"

#include "widgets/common/layoutin.h"

#include <QPainter>
#include <QPushButton>

namespace mb {
namespace {

class SymbolMark : public QWidget {
public:
    SymbolMark(const ThemeSource &theme, Symbol symbol, QWidget *parent)
        : QWidget(parent)
        , m_theme(theme)
        , m_symbol(symbol)
    {
        setFixedSize(theme.theme().u(16), theme.theme().u(16));
        connect(&theme, &ThemeSource::changed, this, QOverload<>::of(&QWidget::update));
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        paintSymbol(painter, rect(), m_symbol, m_theme.theme().dim);
    }

private:
    const ThemeSource &m_theme;
    Symbol m_symbol;
};

} // namespace

ListCard::ListCard(const ThemeSource &theme, const QString &title, QWidget *parent)
    : Card(theme, title, parent)
    , m_theme(theme)
{
    setAccessibleName(title);
    setFlush(true);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void ListCard::setRows(std::vector<Row> rows, const QString &none)
{
    if (m_box && rows == m_rows && none == m_none)
        return;
    m_rows = std::move(rows);
    m_none = none;
    delete m_box;
    m_box = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(m_box, 0);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        column->addWidget(separatorLine(Qt::Horizontal, m_box));
        column->addWidget(makeRow(m_rows[i], static_cast<int>(i)));
    }
    if (m_rows.empty()) {
        auto *text = textLabel(none, TextRole::Body, Tone::Dim, m_box);
        text->setWordWrap(true);
        const int pad = m_theme.theme().u(12);
        text->setContentsMargins(pad, 0, pad, pad);
        column->addWidget(text);
    }
    body().addWidget(m_box);
}

QWidget *ListCard::makeRow(const Row &row, int at)
{
    const Theme &theme = m_theme.theme();
    auto *widget = new QWidget(m_box);
    auto *grid = layoutIn<QGridLayout>(widget, -1, {theme.u(12), theme.u(6), theme.u(12), theme.u(6)});
    grid->setHorizontalSpacing(theme.u(12));
    grid->setVerticalSpacing(0);
    grid->addWidget(new SymbolMark(m_theme, row.symbol, widget), 0, 0, 2, 1, Qt::AlignVCenter);
    auto *name = new ElidedLabel(row.name, widget);
    auto *words = new ElidedLabel(row.words, widget);
    setTextRole(*words, TextRole::Caption);
    setTone(*words, Tone::Dim);
    grid->addWidget(name, 0, 1);
    grid->addWidget(words, 1, 1);
    auto *button = linkButton(row.action, widget);
    button->setAccessibleName(tr("%1: %2").arg(row.action, row.name));
    button->setToolTip(row.tooltip);
    grid->addWidget(button, 0, 2, 2, 1, Qt::AlignVCenter);
    grid->setColumnStretch(1, 1);
    connect(button, &QPushButton::clicked, this, [this, at] { Q_EMIT activated(at); });
    return widget;
}

} // namespace mb
