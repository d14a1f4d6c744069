// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/tracelist.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QContextMenuEvent>
#include <QPainter>

namespace mb {
namespace {

class Swatch : public QWidget {
public:
    Swatch(const ThemeSource &theme, QWidget *parent)
        : QWidget(parent)
        , m_theme(theme)
    {
        setFixedSize(theme.theme().u(28), theme.theme().u(18));
        connect(&theme, &ThemeSource::changed, this, [this] {
            setFixedSize(m_theme.theme().u(28), m_theme.theme().u(18));
            update();
        });
    }
    void setLook(const TraceLook &look)
    {
        m_look = look;
        update();
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        paintSwatch(painter, rect(), m_look, m_theme.theme());
    }

private:
    const ThemeSource &m_theme;
    TraceLook m_look;
};

} // namespace

class TraceList::Entry : public QWidget {
public:
    Entry(const ThemeSource &theme, TraceList &list)
        : QWidget(&list)
    {
        auto *grid = layoutIn<QGridLayout>(
            this, -1, {theme.theme().u(12), theme.theme().u(4), theme.theme().u(8), theme.theme().u(6)});
        grid->setHorizontalSpacing(theme.theme().u(8));
        grid->setVerticalSpacing(0);
        m_swatch = new Swatch(theme, this);
        m_name = textLabel({}, TextRole::Emphasis, Tone::Text, this);
        m_remove = new IconButton(theme, Symbol::Close, TraceList::tr("Remove the trace"), this);
        m_source = textLabel({}, TextRole::Caption, Tone::Dim, this);
        m_rate = textLabel({}, TextRole::Caption, Tone::Dim, this);
        m_lost = textLabel({}, TextRole::Caption, Tone::Ok, this);
        m_value = textLabel({}, TextRole::Body, Tone::Text, this);
        for (QLabel *right : {m_rate, m_lost})
            right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(m_swatch, 0, 0);
        grid->addWidget(m_name, 0, 1, 1, 2);
        auto *more
            = new IconButton(theme, Symbol::ChevronDown, TraceList::tr("Pane, axis, trigger, reference …"), this);
        m_more = more;
        m_statistics = textLabel({}, TextRole::Caption, Tone::Dim, this);
        m_statistics->setWordWrap(true);
        auto *buttons = new QHBoxLayout;
        buttons->setSpacing(0);
        buttons->addWidget(more);
        buttons->addWidget(m_remove);
        grid->addLayout(buttons, 0, 3, Qt::AlignRight);
        grid->addWidget(m_statistics, 3, 1, 1, 3);
        m_statistics->hide();
        QObject::connect(more, &QToolButton::clicked, &list,
            [this, &list] { Q_EMIT list.menuRequested(m_id, m_more->mapToGlobal(QPoint(0, m_more->height()))); });
        grid->addWidget(m_source, 1, 1);
        grid->addWidget(m_rate, 1, 2);
        grid->addWidget(m_lost, 1, 3);
        grid->addWidget(m_value, 2, 1, 1, 3);
        grid->setColumnStretch(1, 1);
        QObject::connect(m_remove, &QToolButton::clicked, &list, [this, &list] { Q_EMIT list.removeRequested(m_id); });
    }
    void show(const Row &row)
    {
        m_id = row.id;
        m_swatch->setLook(row.look);
        m_name->setText(row.name);
        m_remove->setAccessibleName(TraceList::tr("Remove %1").arg(row.name));
        m_source->setText(row.source);
        m_rate->setText(row.rate);
        m_lost->setText(row.lost);
        setTone(*m_lost, row.lossy ? Tone::Caution : Tone::Ok);
        m_value->setText(row.cursors.isEmpty() ? row.value : row.cursors);
        m_statistics->setText(row.statistics);
        m_statistics->setVisible(!row.statistics.isEmpty());
    }

protected:
    void contextMenuEvent(QContextMenuEvent *event) override
    {
        Q_EMIT static_cast<TraceList *>(parentWidget())->menuRequested(m_id, event->globalPos());
    }

private:
    int m_id = 0;
    IconButton *m_more = nullptr;
    QLabel *m_statistics = nullptr;
    Swatch *m_swatch = nullptr;
    QLabel *m_name = nullptr;
    IconButton *m_remove = nullptr;
    QLabel *m_source = nullptr;
    QLabel *m_rate = nullptr;
    QLabel *m_lost = nullptr;
    QLabel *m_value = nullptr;
};

TraceList::TraceList(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    m_column = layoutIn<QVBoxLayout>(this, 0);
    m_column->addStretch(1);
    setAccessibleName(tr("Traces"));
}

void TraceList::rebuild()
{
    while (m_column->count() > 1)
        delete m_column->takeAt(0);
    qDeleteAll(findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    m_entries.clear();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_entries.push_back(new Entry(m_theme, *this));
        m_column->insertWidget(m_column->count() - 1, m_entries.back());
        m_column->insertWidget(m_column->count() - 1, separatorLine(Qt::Horizontal, this));
    }
}

void TraceList::setRows(std::vector<Row> rows)
{
    if (rows == m_rows)
        return;
    const bool sameShape = rows.size() == m_rows.size();
    m_rows = std::move(rows);
    if (!sameShape)
        rebuild();
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_entries[i]->show(m_rows[i]);
}

} // namespace mb
