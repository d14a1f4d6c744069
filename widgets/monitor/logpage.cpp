// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/logpage.h"

#include "files/filebytes.h"
#include "model/family.h"
#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/monitor/noticemodel.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>

#include <algorithm>

namespace mb {
namespace {

constexpr int deviceColumnFrom = 560; ///< units

/// Text anywhere in the row, and at least this severity.
class NoticeFilter final : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void set(const QString &text, Severity least)
    {
        m_text = text.trimmed();
        m_least = least;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        const auto cell = [&](int column) { return sourceModel()->index(row, column, parent); };
        if (cell(0).data(NoticeModel::SeverityRole).toInt() < static_cast<int>(m_least))
            return false;
        return m_text.isEmpty() || cell(NoticeModel::Device).data().toString().contains(m_text, Qt::CaseInsensitive)
            || cell(NoticeModel::Text).data().toString().contains(m_text, Qt::CaseInsensitive);
    }

private:
    QString m_text;
    Severity m_least = Severity::Info;
};

/// Of a device of any family, with the largest number.
int widestName(const QFontMetrics &metrics)
{
    int widest = 0;
    for (const Family *family : families())
        widest = std::max(widest, metrics.horizontalAdvance(qt(family->title) + QStringLiteral(" #888")));
    return widest;
}

} // namespace

LogPage::LogPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_model(new NoticeModel(workbench, theme, this))
{
    setObjectName(QStringLiteral("logPage"));
    setAccessibleName(tr("Log"));
    (void)layoutIn<QVBoxLayout>(this, 0); // that bar and table are added to
    buildBar();
    buildTable();
}

void LogPage::buildBar()
{
    const Theme &theme = m_theme.theme();
    auto *row = new WrapLayout;
    row->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    row->setSpacing(theme.u(8));
    m_search = new SearchField(m_theme, tr("Search the log"), this);
    m_search->setAccessibleName(tr("Search the log"));
    m_search->setKeyHint(QStringLiteral("Ctrl+F"));
    (new PageKeys(*this))->add({QKeySequence::Find}, tr("searches"), [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
    m_severity = new Segmented(tr("Severity"), {tr("All"), tr("Cautions"), tr("Faults")}, this);
    auto *save = new CommandButton(m_theme, Symbol::Export, tr("Save log…"), this);
    row->addWidget(m_search);
    row->addWidget(m_severity);
    row->addSpring();
    row->addWidget(save);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(save, &QPushButton::clicked, this, &LogPage::askSave);
}

void LogPage::buildTable()
{
    const Theme &theme = m_theme.theme();
    auto *filter = new NoticeFilter(this);
    filter->setSourceModel(m_model);
    m_states = new QStackedWidget(this);
    m_states->addWidget(
        new EmptyState(m_theme, Symbol::Log, tr("Nothing yet"), tr("Actions and faults appear here."), m_states));
    m_table = new QTableView(m_states);
    m_table->setAccessibleName(tr("Log lines"));
    m_table->setModel(filter);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(theme.u(24));
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setColumnWidth(NoticeModel::Time, // to the millisecond
        QFontMetrics(theme.font(TextRole::Raw, font())).horizontalAdvance(QStringLiteral("88:88:88.888"))
            + theme.u(32));
    m_table->setColumnWidth(NoticeModel::Glyph, theme.u(32));
    m_table->setColumnWidth(NoticeModel::Device, // a name is whole
        widestName(fontMetrics()) + theme.u(24));
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_states->addWidget(m_table);
    static_cast<QVBoxLayout *>(layout())->addWidget(m_states, 1);
    const auto show = [this] { m_states->setCurrentIndex(m_model->rowCount() > 0 ? 1 : 0); };
    const QScrollBar *const bar = m_table->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) {
        m_follows = value == bar->maximum(); // else somebody reads what was before
    });
    const auto follow = [this] {
        if (m_follows)
            m_table->scrollToBottom();
    };
    connect(bar, &QScrollBar::rangeChanged, this, follow);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, [show, follow] {
        show();
        follow();
    });
    const auto apply = [this, filter] {
        constexpr std::array least{Severity::Info, Severity::Caution, Severity::Danger};
        filter->set(m_search->text(), least[static_cast<std::size_t>(std::max(m_severity->current(), 0))]);
    };
    connect(m_search, &QLineEdit::textChanged, filter, apply);
    connect(m_severity, &Segmented::currentChanged, filter, apply);
    show();
}

/// Where it is narrow the device stands before what it said: both columns would be too narrow to read.
void LogPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool narrow = width() < m_theme.theme().u(deviceColumnFrom);
    m_table->setColumnHidden(NoticeModel::Device, narrow);
    m_model->setNamed(narrow);
}

QString LogPage::text() const
{
    QString all;
    for (const Notice &notice : m_workbench.notices())
        all += m_model->timeText(notice) + QLatin1Char('\t') + notice.device + QLatin1Char('\t') + notice.text
            + QLatin1Char('\n');
    return all;
}

void LogPage::askSave()
{
    const auto save = [this](const QString &path) {
        const auto saved = saveFile(path.toStdString(), text().toUtf8());
        m_workbench.report(saved ? Severity::Good : Severity::Danger, {},
            saved ? tr("log saved to %1").arg(path) : errorText(saved.error()));
    };
    askWhereToSave(*this, tr("Save the log"), tr("Text (*.log *.txt)"), QStringLiteral("motorbench.log"), save);
}

} // namespace mb
