// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportspage.h"

#include "tuning/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/trialnotebook.h"
#include "widgets/report/reportdrawings.h"
#include "widgets/report/reportorder.h"

#include <QAbstractTextDocumentLayout>
#include <QDateTime>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPointer>
#include <QStackedWidget>
#include <QTextBrowser>

#include <algorithm>

namespace mb {
namespace {

constexpr int listWidth = 380;

QString whenOf(double time)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(time * 1000.0)), QLocale::ShortFormat);
}

std::string notebookUnit(const DeviceView &view)
{
    return tuning::unitOf(view.identity, view.selector, view.link.starts_with("sim:"));
}

} // namespace

ReportsPage::ReportsPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_order(new ReportOrder(workbench, *this))
{
    setObjectName(QStringLiteral("reportsPage"));
    setAccessibleName(tr("Reports"));
    m_states = new QStackedWidget(this);
    m_states->addWidget(new EmptyState(theme, Symbol::Document, tr("Nothing to report yet"),
        tr("The cards of units, their tunings and their trials appear here."), m_states));
    auto *both = new QWidget(m_states);
    auto *row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(buildList());
    row->addWidget(separatorLine(Qt::Vertical, both));
    row->addWidget(buildPreview(), 1);
    m_states->addWidget(both);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_states);
    addKeys();
    connect(&workbench, &Workbench::changed, this, &ReportsPage::follow);
}

QWidget *ReportsPage::buildList()
{
    const Theme &theme = m_theme.theme();
    auto *side = new QWidget(m_states);
    side->setFixedWidth(theme.u(listWidth));
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    m_search = new SearchField(m_theme, tr("Search the reports"), side);
    m_search->setAccessibleName(tr("Search the reports"));
    head->addWidget(m_search);
    column->addLayout(head);
    m_list = new QListWidget(side);
    m_list->setAccessibleName(tr("Reports, newest first"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    column->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &ReportsPage::fill);
    connect(m_list, &QListWidget::currentRowChanged, this, &ReportsPage::preview);
    return side;
}

QWidget *ReportsPage::buildPreview()
{
    const Theme &theme = m_theme.theme();
    auto *area = new QWidget(m_states);
    auto *column = new QVBoxLayout(area);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(12), theme.u(8), theme.u(12), theme.u(8));
    row->addWidget(new SectionLabel(tr("Preview"), area));
    row->addStretch(1);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Write report…"), area);
    m_export->setKeyHint(QStringLiteral("Ctrl+P"));
    m_export->setEnabled(false);
    row->addWidget(m_export);
    column->addLayout(row);
    column->addWidget(separatorLine(Qt::Horizontal, area));
    m_text = new QTextBrowser(area);
    m_text->setAccessibleName(tr("Preview of the report"));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    QPalette paper = m_text->palette(); // as it is printed, in both themes
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, Qt::black);
    m_text->setPalette(paper);
    m_text->setStyleSheet(QStringLiteral("QTextBrowser { background: white; color: black; }"));
    column->addWidget(m_text, 1);
    connect(m_export, &QPushButton::clicked, this, &ReportsPage::exportChosen);
    return area;
}

void ReportsPage::addKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({QKeySequence::Print}, tr("writes the report that is looked at"), [this] { exportChosen(); });
    keys->add({QKeySequence::Find}, tr("goes to the search"), [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
}

void ReportsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_asked.clear(); // there may be new trials
    follow();
}

/// Once for the units that are here.
void ReportsPage::follow()
{
    const auto &devices = m_workbench.snapshot().devices;
    QString asked;
    for (const DeviceView &view : devices)
        asked += qt(view.selector) + QLatin1Char(' ');
    if (!isVisible() || asked == m_asked)
        return;
    m_asked = asked;
    m_entries.clear();
    for (const DeviceView &view : devices) {
        m_entries.push_back({view.id, {}, 0.0, tr("Card of %1").arg(titleOf(view)), qt(view.identity.serial)});
        ReportWish wish;
        wish.unit = notebookUnit(view);
        m_workbench.trials().gather(wish,
            [self = QPointer<ReportsPage>(this), id = view.id, asked](const Result<std::vector<ReportUnit>> &units) {
                if (!self || !units || self->m_asked != asked)
                    return;
                for (const ReportUnit &unit : *units)
                    self->take(id, unit);
                self->fill();
            });
    }
    fill();
}

void ReportsPage::take(DeviceId device, const ReportUnit &unit)
{
    const DeviceView *view = m_workbench.snapshot().device(device);
    const QString name = view ? titleOf(*view) : qt(unit.selector);
    for (const KeptTuning &tuning : unit.tunings)
        m_entries.push_back({device, {tuning.report.trials, {}, true}, tuning.time, tr("Tuning of %1").arg(name),
            tr("%1 trials").arg(tuning.report.trials.size())});
    for (const KeptTrial &trial : unit.history)
        m_entries.push_back({device, {{trial.number}, {}, false}, trial.time,
            tr("Trial #%1 of %2").arg(trial.number).arg(name), qt(trial.note)});
}

void ReportsPage::fill()
{
    std::stable_sort(m_entries.begin(), m_entries.end(), [](const Entry &a, const Entry &b) {
        return (a.time == 0.0) != (b.time == 0.0) ? a.time == 0.0 : a.time > b.time;
    });
    const int before = m_list->currentRow();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const Entry &entry = m_entries[i];
        const QString when = entry.time > 0.0 ? whenOf(entry.time) : tr("as it is now");
        const QString text = entry.title + QLatin1Char('\n') + when
            + (entry.about.isEmpty() ? QString() : QStringLiteral(" · ") + entry.about);
        if (!text.contains(m_search->text().trimmed(), Qt::CaseInsensitive))
            continue;
        auto *item = new QListWidgetItem(text, m_list);
        item->setData(Qt::UserRole, static_cast<int>(i));
    }
    m_states->setCurrentIndex(m_entries.empty() ? 0 : 1);
    m_list->setCurrentRow(std::clamp(before, m_list->count() > 0 ? 0 : -1, m_list->count() - 1));
    preview();
}

const ReportsPage::Entry *ReportsPage::chosen() const
{
    const QListWidgetItem *item = m_list->currentItem();
    return item ? &m_entries.at(static_cast<std::size_t>(item->data(Qt::UserRole).toInt())) : nullptr;
}

void ReportsPage::preview()
{
    const Entry *entry = chosen();
    const DeviceView *view = entry ? m_workbench.snapshot().device(entry->device) : nullptr;
    m_export->setEnabled(view != nullptr);
    const int asked = ++m_shown;
    if (!view)
        return m_text->clear();
    m_order->make(*view, entry->wish, [self = QPointer<ReportsPage>(this), asked](const Result<Report> &report) {
        if (!self || self->m_shown != asked)
            return;
        if (!report)
            return self->m_text->setPlainText(errorText(report.error()));
        auto *drawings = new ReportDrawings(self->m_text);
        self->m_text->document()->documentLayout()->registerHandler(QTextFormat::ImageObject, drawings);
        self->m_text->setHtml(drawings->takeFrom(htmlOf(*report)));
        delete std::exchange(self->m_drawings, drawings);
    });
}

QString ReportsPage::previewText() const
{
    return m_text->toPlainText();
}

void ReportsPage::exportChosen()
{
    const Entry *entry = chosen();
    if (const DeviceView *view = entry ? m_workbench.snapshot().device(entry->device) : nullptr)
        m_order->ask(*view, entry->wish);
}

void ReportsPage::write(const QString &path)
{
    const Entry *entry = chosen();
    if (const DeviceView *view = entry ? m_workbench.snapshot().device(entry->device) : nullptr)
        m_order->write(*view, entry->wish, path);
}

} // namespace mb
