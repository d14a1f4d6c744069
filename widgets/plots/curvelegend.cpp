// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curvelegend.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/wraplayout.h"

#include <QPainter>

#include <utility>

namespace mb {
namespace {

constexpr double swatchBandShare = 0.16; ///< as of the band itself

class Swatch : public QWidget {
public:
    Swatch(const ThemeSource &theme, CurveLegend::Entry entry, QWidget *parent)
        : QWidget(parent)
        , m_theme(theme)
        , m_entry(std::move(entry))
    {
        const bool line = m_entry.shape == CurveLegend::Shape::Line || m_entry.shape == CurveLegend::Shape::Band;
        setFixedSize(theme.theme().u(line ? 26 : 12), theme.theme().u(14));
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        const Theme &look = m_theme.theme();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor colour = look.trace(m_entry.look.colourRole());
        switch (m_entry.shape) {
        case CurveLegend::Shape::Band:
            colour.setAlphaF(swatchBandShare);
            painter.fillRect(rect(), colour);
            [[fallthrough]];
        case CurveLegend::Shape::Line: {
            TraceLook plain = m_entry.look;
            plain.marker = TraceMarker::None;
            return paintSwatch(painter, rect(), plain, look);
        }
        case CurveLegend::Shape::Faint: colour = look.faint; [[fallthrough]];
        case CurveLegend::Shape::Hollow:
        case CurveLegend::Shape::Filled: break;
        }
        const double half = look.u(8) / 2.0;
        const QPointF middle = QRectF(rect()).center();
        painter.setPen(QPen(colour, 1.4));
        painter.setBrush(m_entry.shape == CurveLegend::Shape::Filled ? QBrush(colour) : QBrush());
        painter.drawPolygon(
            QPolygonF({middle + QPointF(-half, half), middle + QPointF(half, half), middle + QPointF(0.0, -half)}));
    }

private:
    const ThemeSource &m_theme;
    CurveLegend::Entry m_entry;
};

} // namespace

CurveLegend::CurveLegend(const ThemeSource &theme, const QString &title, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_row(new WrapLayout(this))
{
    const Theme &look = theme.theme();
    m_row->setContentsMargins(look.u(12), look.u(7), look.u(12), look.u(7));
    m_row->setSpacing(look.u(14));
    m_row->setLineSpacing(look.u(5));
    if (!title.isEmpty()) {
        m_title = new SectionLabel(title, this);
        m_row->addWidget(m_title);
    }
}

void CurveLegend::setTitle(const QString &title)
{
    if (m_title)
        static_cast<QLabel *>(m_title)->setText(title);
}

void CurveLegend::setEntries(const std::vector<Entry> &entries)
{
    if (entries == m_entries)
        return;
    m_entries = entries;
    for (QWidget *one : std::exchange(m_shown, {}))
        delete one;
    for (const Entry &entry : m_entries) {
        auto *const shown = new QWidget(this);
        auto *const row = layoutIn<QHBoxLayout>(shown, m_theme.theme().u(6));
        row->addWidget(new Swatch(m_theme, entry, shown), 0, Qt::AlignVCenter);
        auto *const words = new QLabel(entry.name, shown);
        setTextRole(*words, TextRole::Caption);
        row->addWidget(words);
        m_row->addWidget(shown);
        m_shown.push_back(shown);
        shown->show();
    }
}

} // namespace mb
