// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportspage.h"

#include "model/family.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/leastheight.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/trialnotebook.h"
#include "widgets/common/turningsplitter.h"
#include "widgets/common/visitarchive.h"
#include "widgets/common/wraplayout.h"
#include "widgets/report/entrydelegate.h"
#include "widgets/report/reportdrawings.h"
#include "widgets/report/reportorder.h"

#include <QAbstractTextDocumentLayout>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QTextBrowser>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int reportsWidth = 380; ///< units
constexpr int previewWidth = 700;
constexpr int pageWidth = 860;
constexpr int previewBesideFrom = 760;
constexpr int newestEntries = 2000; ///< of the journal, in the list

/// What the books tell of the units that are here.
struct Gathering {
    std::vector<ReportEntry> entries;
    std::size_t missing = 0; ///< answers
    bool isTold = false;     ///< that one cannot be read: it is one book, asked for each unit
};

/// Of a unit that is here as it is now, not as it was when the list was made.
ReportUnit unitOf(const ReportEntry &entry, const Snapshot &shot)
{
    for (const DeviceView &view : shot.devices) {
        if (entry.kind == ReportEntry::Kind::Visit || view.selector != entry.unit.selector)
            continue;
        if (ReportUnit now = reportUnitOf(view); now.unit == entry.unit.unit)
            return now;
    }
    return entry.unit;
}

void addBooks(std::vector<ReportEntry> &entries, const ReportUnit &here, const ReportUnit &unit)
{
    const QString name = (here.family ? qt(here.family->title) : qt(here.identity.family)) + QStringLiteral(" #")
        + QString::number(here.identity.address);
    for (const KeptTuning &tuning : unit.tunings) {
        ReportEntry entry;
        entry.kind = ReportEntry::Kind::Tuning;
        entry.unit = here;
        entry.wish = {tuning.report.trials, {}, true};
        entry.time = tuning.time;
        entry.title = ReportsPage::tr("Tuning of %1").arg(name);
        entry.about = ReportsPage::tr("%1 trials").arg(tuning.report.trials.size());
        entries.push_back(std::move(entry));
    }
    for (const KeptTrial &trial : unit.history) {
        ReportEntry entry;
        entry.kind = ReportEntry::Kind::Trial;
        entry.unit = here;
        entry.wish = {{trial.number}, {}, false};
        entry.time = trial.time;
        entry.title = ReportsPage::tr("Trial #%1 of %2").arg(trial.number).arg(name);
        entry.about = qt(trial.note);
        entries.push_back(std::move(entry));
    }
}

/// The pixels of its sheet are those of a page; on a screen they follow the text around it.
QString inSizeOf(const QString &html, double scale)
{
    static const QRegularExpression size(QStringLiteral("font-size: (\\d+)px"));
    QString scaled;
    int from = 0;
    for (auto all = size.globalMatch(html); all.hasNext();) {
        const QRegularExpressionMatch one = all.next();
        scaled += html.mid(from, one.capturedStart() - from)
            + QStringLiteral("font-size: %1px").arg(qRound(one.captured(1).toInt() * scale));
        from = one.capturedEnd();
    }
    return scaled + html.mid(from);
}

} // namespace

ReportsPage::ReportsPage(Workbench &workbench, const Selection &selection, std::span<const Family *const> families,
    const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
    , m_families(families)
    , m_order(new ReportOrder(workbench, *this))
{
    setObjectName(QStringLiteral("reportsPage"));
    setAccessibleName(tr("Reports"));
    m_states = new QStackedWidget(this);
    m_states->addWidget(new EmptyState(theme, Symbol::Document, tr("Nothing to report yet"),
        tr("The cards of units, their tunings and their trials appear here."), m_states));
    auto *both = new TurningSplitter(theme, previewBesideFrom, m_states);
    both->setHandleWidth(1);
    both->addWidget(buildList());
    both->addWidget(buildPreview());
    both->setStretchFactor(1, 1);
    both->setSizes({theme.theme().u(reportsWidth), theme.theme().u(previewWidth)});
    m_states->addWidget(both);
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addWidget(m_states);
    addKeys();
    connect(&workbench, &Workbench::unitEnded, this, &ReportsPage::askJournal);
    connect(&workbench, &Workbench::changed, this, &ReportsPage::follow);
    connect(&selection, &Selection::changed, this, &ReportsPage::followSelection);
    connect(&theme, &ThemeSource::changed, this, &ReportsPage::fill); // shapes have colours of their own
}

QWidget *ReportsPage::buildList()
{
    const Theme &theme = m_theme.theme();
    auto *side = new QWidget(m_states);
    auto *column = layoutIn<QVBoxLayout>(side, 0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    m_search = new SearchField(m_theme, tr("Search the reports"), side);
    m_search->setAccessibleName(tr("Search the reports"));
    head->addWidget(m_search);
    column->addLayout(head);
    auto *kindRow = new QHBoxLayout;
    kindRow->setContentsMargins(theme.u(12), 0, theme.u(12), theme.u(8));
    m_filter = new Segmented(tr("What is listed"), {tr("All"), tr("Cards"), tr("Tuning"), tr("Journal")}, side);
    m_filter->setEven(true);
    kindRow->addWidget(m_filter);
    column->addLayout(kindRow);
    m_list = new QListWidget(side);
    m_list->setAccessibleName(tr("Reports, newest first"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setItemDelegate(new EntryDelegate(m_theme, m_list));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setResizeMode(QListView::Adjust);
    column->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &ReportsPage::fill);
    connect(m_filter, &Segmented::currentChanged, this, &ReportsPage::fill);
    connect(m_list, &QListWidget::currentRowChanged, this, &ReportsPage::preview);
    return side;
}

QWidget *ReportsPage::buildPreview()
{
    const Theme &theme = m_theme.theme();
    auto *area = new LeastHeight(m_states);
    auto *column = layoutIn<QVBoxLayout>(area, 0);
    auto *row = new WrapLayout;
    row->setContentsMargins(theme.u(12), theme.u(8), theme.u(12), theme.u(8));
    row->setSpacing(theme.u(8));
    row->addWidget(new SectionLabel(tr("Preview"), area));
    row->addSpring();
    auto *form = new QComboBox(area);
    form->setAccessibleName(tr("Size of the report"));
    form->addItem(tr("Pages, A4"));
    form->addItem(tr("Label, 62 × 29 mm"));
    row->addWidget(form);
    m_table = new CommandButton(m_theme, Symbol::Export, tr("Save CSV…"), area);
    m_table->setToolTip(tr("The entries of the journal that are listed, as a table"));
    row->addWidget(m_table);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Write report…"), area);
    m_export->setKeyHint(QStringLiteral("Ctrl+P"));
    m_export->setEnabled(false);
    row->addWidget(m_export);
    column->addLayout(row);
    addNote(*column, area);
    column->addWidget(separatorLine(Qt::Horizontal, area));
    m_text = new QTextBrowser(area);
    m_text->setAccessibleName(tr("Preview of the report"));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    m_text->setMaximumWidth(theme.u(pageWidth)); // lines that are longer are not read
    QPalette paper = m_text->palette();          // as it is printed, in both themes
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, Qt::black);
    m_text->setPalette(paper);
    m_text->setStyleSheet(QStringLiteral("QTextBrowser { background: white; color: black; border: 1px solid gray; }"));
    auto *desk = new QHBoxLayout; // on which the sheet lies
    desk->setContentsMargins(theme.u(12), theme.u(12), theme.u(12), 0);
    desk->addWidget(m_text);
    column->addLayout(desk, 1);
    connect(m_export, &QPushButton::clicked, this, &ReportsPage::exportChosen);
    connect(m_table, &QPushButton::clicked, this, &ReportsPage::askTable);
    connect(form, qOverload<int>(&QComboBox::currentIndexChanged), this, &ReportsPage::setForm);
    return area;
}

/// In a row of its own: beside the orders it would be too narrow to read.
void ReportsPage::addNote(QVBoxLayout &column, QWidget *area)
{
    const Theme &theme = m_theme.theme();
    m_note = new QLineEdit(area);
    m_note->setPlaceholderText(tr("Note on this entry"));
    m_note->setAccessibleName(tr("Note on this entry of the journal"));
    m_note->hide();
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(12), 0, theme.u(12), theme.u(8));
    row->addWidget(m_note);
    column.addLayout(row);
    connect(m_note, &QLineEdit::editingFinished, this, &ReportsPage::noteEdited);
}

void ReportsPage::addKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({QKeySequence::Print}, tr("writes the report that is looked at"), [this] { exportChosen(); });
    keys->add({QKeySequence::Find}, tr("goes to the search"), [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
}

void ReportsPage::setFilter(Filter filter)
{
    m_filter->setCurrent(filter);
}

void ReportsPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_asked.clear(); // there may be new trials
    askJournal();
    follow();
}

void ReportsPage::askJournal()
{
    if (!isVisible())
        return;
    m_workbench.visits().list({}, guarded(this, [this](const Result<std::vector<service::Visit>> &visits) {
        if (!visits)
            return m_workbench.report(Severity::Danger, {}, errorText(visits.error()));
        m_journal.clear();
        for (auto visit = visits->rbegin(); visit != visits->rend(); ++visit) {
            if (static_cast<int>(m_journal.size()) == newestEntries)
                break;
            const auto family
                = std::ranges::find_if(m_families, [visit](const Family *each) { return each->key == visit->family; });
            m_journal.push_back(entryOf(*visit, family == m_families.end() ? nullptr : *family));
        }
        fill();
    }));
}

/// Once for the units that are here. Until all is answered the list stays as it is: what was chosen may be in the last answer.
void ReportsPage::follow()
{
    const auto &devices = m_workbench.snapshot().devices;
    QString asked;
    for (const DeviceView &view : devices)
        asked += qt(view.selector) + QLatin1Char(' ');
    if (!isVisible() || asked == m_asked)
        return;
    m_asked = asked;
    const auto gathering = std::make_shared<Gathering>();
    gathering->missing = devices.size();
    for (const DeviceView &view : devices) {
        ReportEntry card;
        card.unit = reportUnitOf(view);
        card.title = tr("Card of %1").arg(titleOf(view));
        card.about = qt(view.identity->serial);
        ReportWish wish;
        wish.unit = card.unit.unit;
        gathering->entries.push_back(card);
        m_workbench.trials().gather(wish,
            guarded(this, [this, here = card.unit, asked, gathering](const Result<std::vector<ReportUnit>> &units) {
                if (m_asked != asked)
                    return;
                if (!units && !std::exchange(gathering->isTold, true))
                    m_workbench.report(Severity::Danger, {}, errorText(units.error()));
                for (const ReportUnit &unit : units ? *units : std::vector<ReportUnit>())
                    addBooks(gathering->entries, here, unit);
                if (--gathering->missing == 0) {
                    m_entries = std::move(gathering->entries);
                    followSelection();
                    fill();
                }
            }));
    }
    if (!devices.empty() && !m_entries.empty())
        return;
    m_entries = gathering->entries;
    fill();
}

/// The card of a device that was just selected; what somebody chooses in the list afterwards stays.
void ReportsPage::followSelection()
{
    const DeviceView *const view = m_workbench.snapshot().device(m_selection.device());
    const auto card = std::ranges::find_if(m_entries, [view](const ReportEntry &entry) {
        return view && entry.kind == ReportEntry::Kind::Card && entry.unit.selector == view->selector;
    });
    if (card == m_entries.end() || std::exchange(m_followed, view->id) == view->id)
        return;
    m_chosen = *card;
    fill();
}

bool ReportsPage::isShown(const ReportEntry &entry) const
{
    using Kind = ReportEntry::Kind;
    const int filter = m_filter->current();
    const bool kind = filter == All || (filter == Cards && entry.kind == Kind::Card)
        || (filter == Tunings && (entry.kind == Kind::Tuning || entry.kind == Kind::Trial))
        || (filter == Journal && entry.kind == Kind::Visit);
    return kind && entry.contains(m_search->text().trimmed());
}

/// Cards first, then by time; what was chosen stays so.
void ReportsPage::fill()
{
    std::vector<const ReportEntry *> all;
    for (const auto *entries : {&m_entries, &m_journal}) {
        for (const ReportEntry &entry : *entries)
            all.push_back(&entry);
    }
    std::ranges::stable_sort(all, [](const ReportEntry *a, const ReportEntry *b) {
        return (a->time == 0.0) != (b->time == 0.0) ? a->time == 0.0 : a->time > b->time;
    });
    int row = m_list->currentRow();
    bool isFound = false;
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    int visits = 0;
    for (const ReportEntry *entry : all) {
        if (!isShown(*entry))
            continue;
        auto *item = new QListWidgetItem(entry->text(), m_list);
        if (entry->glyph)
            item->setIcon(glyphIcon(*entry->glyph, m_theme.theme()));
        if (m_chosen && entry->isSameAs(*m_chosen)
            && (!std::exchange(isFound, true) || entry->unit.selector == m_chosen->unit.selector))
            row = m_list->count() - 1;
        const bool visit = entry->kind == ReportEntry::Kind::Visit;
        visits += visit;
        item->setData(Qt::UserRole, static_cast<int>(entry - (visit ? m_journal : m_entries).data()));
        item->setData(Qt::UserRole + 1, visit);
    }
    m_table->setEnabled(visits > 0);
    m_states->setCurrentIndex(all.empty() ? 0 : 1);
    m_list->setCurrentRow(std::clamp(row, m_list->count() > 0 ? 0 : -1, m_list->count() - 1));
    preview();
}

const ReportEntry *ReportsPage::chosen() const
{
    const QListWidgetItem *item = m_list->currentItem();
    if (!item)
        return nullptr;
    const auto &entries = item->data(Qt::UserRole + 1).toBool() ? m_journal : m_entries;
    return &entries.at(static_cast<std::size_t>(item->data(Qt::UserRole).toInt()));
}

void ReportsPage::preview()
{
    const ReportEntry *entry = chosen();
    m_chosen = entry ? std::optional(*entry) : std::nullopt;
    m_export->setEnabled(m_chosen.has_value());
    const int asked = ++m_shown;
    if (m_chosen)
        lookAt(*m_chosen, asked);
    else
        m_text->clear();
    bindNote();
}

void ReportsPage::lookAt(const ReportEntry &entry, int asked)
{
    m_order->make(
        unitOf(entry, m_workbench.snapshot()), entry.wish, guarded(this, [this, asked](const Result<Report> &report) {
            if (m_shown != asked)
                return;
            if (!report)
                return m_text->setPlainText(errorText(report.error()));
            const double scale = m_theme.theme().bodyPointSize / 10.0;
            auto *drawings = new ReportDrawings(m_text, scale);
            m_text->document()->documentLayout()->registerHandler(QTextFormat::ImageObject, drawings);
            m_text->setHtml(drawings->takeFrom(inSizeOf(htmlOf(*report, m_order->form()), scale)));
            delete std::exchange(m_drawings, drawings);
        }));
}

/// The note is on what is chosen. What was begun on another entry is kept there; what is being typed on this one stays.
void ReportsPage::bindNote()
{
    const bool visit = m_chosen && m_chosen->kind == ReportEntry::Kind::Visit;
    const std::string id = visit ? m_chosen->visit.id : std::string();
    const QString typed = m_note->text();
    const bool begun = typed != m_noted.kept;
    m_note->setVisible(visit);
    if (begun && id == m_noted.of)
        return;
    const std::string before = std::exchange(m_noted.of, id);
    m_noted.kept = visit ? qt(m_chosen->visit.note) : QString();
    m_note->setText(m_noted.kept);
    if (begun && !before.empty())
        keepNote(before, typed, {});
}

QString ReportsPage::previewText() const
{
    return m_text->toPlainText();
}

void ReportsPage::setForm(int form)
{
    m_order->setForm(form == 1 ? ReportForm::Label : ReportForm::Pages);
    preview();
}

void ReportsPage::noteEdited()
{
    if (m_noted.of.empty() || m_note->text() == m_noted.kept)
        return;
    const QString before = std::exchange(m_noted.kept, m_note->text());
    keepNote(m_noted.of, m_noted.kept, before);
}

/// `before`: what the journal has where it does not take it.
void ReportsPage::keepNote(const std::string &visit, const QString &note, const QString &before)
{
    m_workbench.visits().setNote(visit, note, guarded(this, [this, visit, before](const Result<void> &result) {
        if (!result)
            m_workbench.report(Severity::Danger, {}, errorText(result.error()));
        if (!result && m_noted.of == visit)
            m_noted.kept = before; // still to be kept
        askJournal();
    }));
}

void ReportsPage::exportChosen()
{
    if (const ReportEntry *entry = chosen())
        m_order->ask(unitOf(*entry, m_workbench.snapshot()), entry->wish);
}

void ReportsPage::write(const QString &path)
{
    if (const ReportEntry *entry = chosen())
        m_order->write(unitOf(*entry, m_workbench.snapshot()), entry->wish, path);
}

void ReportsPage::askTable()
{
    askWhereToSave(*this, tr("Save the journal"), tr("Table (*.csv)"), QStringLiteral("journal.csv"),
        [this](const QString &path) { saveTable(path); });
}

void ReportsPage::saveTable(const QString &path)
{
    std::vector<service::Visit> visits;
    for (auto entry = m_journal.rbegin(); entry != m_journal.rend(); ++entry) {
        if (isShown(*entry))
            visits.push_back(entry->visit);
    }
    m_workbench.visits().exportTo(path, std::move(visits), guarded(this, [this, path](const Result<void> &result) {
        m_workbench.report(result ? Severity::Good : Severity::Danger, {},
            result ? tr("the journal is in %1").arg(path) : errorText(result.error()));
    }));
}

} // namespace mb
