// SPDX-License-Identifier: GPL-3.0-or-later
// The style sheet of the page, as it stands in it.
#include "verification/report/page.hpp"

namespace ehd::report {

namespace {

constexpr const char* style = R"css(
:root{--pass:#1d7a3a;--fail:#b3261e;--warn:#8a5a00;--panel:#f5f6f8}
@media screen and (prefers-color-scheme:dark){
:root:not([data-theme=light]){--pass:#6fd08c;--fail:#ff8a80;--warn:#f0c060;--panel:#1e2329;color-scheme:dark}
}
@media screen{:root[data-theme=dark]{--pass:#6fd08c;--fail:#ff8a80;--warn:#f0c060;--panel:#1e2329;color-scheme:dark}}
:root[data-theme=light]{color-scheme:light}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.5 system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
body{display:grid;grid-template-columns:190px minmax(0,1fr);align-items:start}
.page{max-width:1180px;padding:0 20px;min-width:0}
header{padding-top:18px}
.skip{position:absolute;left:-9999px}
.skip:focus{left:8px;top:8px;z-index:9;background:var(--paper);padding:6px 10px}
nav{position:sticky;top:0;max-height:100vh;overflow:auto;display:flex;flex-direction:column;gap:2px;
padding:22px 6px 12px 16px;font-size:0.92rem}
nav a{padding:4px 8px;text-decoration:none;border-left:3px solid transparent}
nav a:hover,nav a:focus{text-decoration:underline}
nav a[aria-current]{border-color:var(--s1);background:var(--panel);color:var(--ink)}
section,h3,tr,figure,svg,details{scroll-margin-top:12px}
:target{outline:2px solid var(--s1);outline-offset:3px}
section:target{outline:none}
:focus-visible{outline:2px solid var(--s1);outline-offset:2px}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 8px}
h2{font-size:1.35rem;margin:40px 0 10px;padding-top:10px;border-top:2px solid var(--grid)}
h3{font-size:1.08rem;margin:26px 0 8px}
p{max-width:80ch;margin:8px 0}
a{color:var(--s1)}
.whole{white-space:nowrap}
code{font:0.9em ui-monospace,Menlo,Consolas,monospace;overflow-wrap:break-word}
pre{white-space:pre-wrap;overflow-wrap:anywhere;background:var(--panel);padding:10px 12px;
font:0.85rem ui-monospace,Menlo,Consolas,monospace}
button,input,select{font:inherit;color:var(--ink);background:var(--panel);border:1px solid var(--soft);
border-radius:4px;padding:3px 10px}
input{min-width:0;max-width:100%}
.verdict{font-size:1.1rem;border-left:6px solid var(--pass);padding:8px 14px;background:var(--panel);max-width:none}
.verdict.fail{border-color:var(--fail)}
.absent{color:var(--soft);font-style:italic}
.scroll{overflow-x:auto;max-width:100%;margin:10px 0}
table{border-collapse:collapse;font-size:0.88rem;line-height:1.35}
caption{text-align:left;font-weight:600;padding:4px 0;caption-side:top}
th,td{padding:3px 12px 3px 0;text-align:left;vertical-align:top;border-bottom:1px solid var(--grid)}
th[scope=row]{font-weight:500}
thead th{border-bottom:2px solid var(--soft);}
.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.name{white-space:nowrap}
.folded{display:none}
thead .number{white-space:normal}
.wide{min-width:16em}
td.wide code,th code{display:inline-block}
.claims th[scope=row]{min-width:14em;max-width:22em;overflow-wrap:anywhere}
.claims th a{color:inherit;text-decoration-color:var(--grid)}
.below>td{border-bottom:1px solid var(--grid);padding:0}
.below details{margin:0 0 6px}
.scroll{container-type:inline-size}
.opens{position:relative;display:inline-block}
.below details>*{position:sticky;left:0;width:100cqw}
.below details>figure{width:min(100cqw,600px)}
.js .below:not(:has(details[open])){display:none}
.spark{display:block;width:100px;height:25px}
.spark path{fill:none;stroke-width:1.5}
.spark .s1 path{stroke:var(--s1)}
.spark .s3 path{stroke:var(--s3)}
b.fail{color:var(--fail)}
.cases td,.cases th{vertical-align:middle;padding-top:1px;padding-bottom:1px}
.overview td,.overview th[scope=row]{min-width:9em}
td.pass,td.converged{color:var(--pass)}
td.fail,td.diverged{color:var(--fail);font-weight:700}
td.inconclusive,td.tolerance-not-met,td.limit-reached,td.under-resolved{color:var(--warn);font-weight:700}
.claim{border-left:4px solid var(--fail);padding:4px 14px;margin:12px 0;background:var(--panel)}
.claim.inconclusive{border-color:var(--warn)}
.claim p{margin:4px 0;overflow-wrap:anywhere}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,440px),1fr));
gap:22px 26px;align-items:start}
.figures.wide-figure{grid-template-columns:1fr}
.figures.trio{grid-template-columns:repeat(auto-fill,minmax(min(100%,340px),1fr))}
.unseen{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.figures.polars{grid-template-columns:repeat(auto-fill,minmax(min(100%,340px),1fr))}
figure{margin:0;min-width:0}
svg.plot{display:block;width:100%;height:auto}
figcaption{font-size:0.86rem;color:var(--soft);margin-top:2px;overflow-wrap:anywhere}
figcaption b{color:var(--ink)}
.anchor{white-space:nowrap}
.tools{display:flex;flex-wrap:wrap;gap:6px;margin-top:4px}
.tools button{padding:0 8px;font-size:0.82rem}
.zoomable{cursor:crosshair;touch-action:pan-x pan-y}
.zoom-box{fill:var(--s1);fill-opacity:.15;stroke:var(--s1)}
.zoomed .slope,.zoomed .series>text{display:none}
details{margin:10px 0}
summary{cursor:pointer;font-weight:600;padding:2px 0}
.controls{display:none;flex-wrap:wrap;gap:8px;margin:8px 0}
.js .controls{display:flex}
.theme{display:none}
.js .theme{display:inline-block;margin-top:10px;align-self:flex-start}
.js .key{cursor:pointer}
.key.off{opacity:.35}
.series.off{display:none}
.readout{position:fixed;z-index:5;pointer-events:none;background:var(--paper);color:var(--ink);
border:1px solid var(--soft);border-radius:4px;padding:3px 8px;font-size:0.82rem;line-height:1.35;
max-width:min(90vw,340px);white-space:pre-line}
dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 16px;margin:8px 0}
dt{color:var(--soft)}
dd{margin:0;overflow-wrap:anywhere;min-width:0}
@media (max-width:1000px){
body{display:block}
.page{margin:0 auto}
nav{flex-flow:row wrap;align-items:center;white-space:nowrap;z-index:4;background:var(--paper);padding:4px 12px;
border-bottom:1px solid var(--grid)}
nav a{border-left:0;border-bottom:3px solid transparent}
.js .theme{margin:0 0 0 auto}
section,h3,tr,figure,svg,details{scroll-margin-top:56px}
}
@media (max-width:600px){
.page{padding:0 12px}
nav{gap:0;padding:2px 6px;font-size:0.84rem}
nav a{padding:2px 6px}
section,h3,tr,figure,svg,details{scroll-margin-top:72px}
.folds thead{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.folds tr,.folds .below>td{display:block;border:0}
.folds .below>td{padding:0}
.folds tr{border-bottom:1px solid var(--grid);padding:6px 0}
.folds .below{border:0;padding:0}
.folds th[scope=row]{font-weight:700}
.folds .folded{display:inline}
.folds td,.folds th[scope=row]{display:inline-block;border:0;padding:1px 14px 1px 0;min-width:0;text-align:left}
.folds td:empty{display:none}
.folds td[data-column]:not(:has(.opens))::before{content:attr(data-column) ": ";color:var(--soft);font-weight:400}
.overview td:not(:empty){display:block}
.claims th[scope=row]{min-width:0}
.folds.claims td[data-column].wide::before{content:none}
dl{grid-template-columns:1fr}
dt{margin-top:6px}
}
@media print{
body{font-size:10pt}
body{display:block}
.page{max-width:none;padding:0}
nav,.controls,.readout,.tools,.anchor,.skip{display:none!important}
.js .below:not(:has(details[open])){display:table-row}
figure,.claim{break-inside:avoid}
h2,h3{break-after:avoid}
.scroll{overflow:visible}
.scroll{container-type:normal}
.below details>*{position:static;width:auto}
table{font-size:8pt}
.cases{font-size:7.5pt}
.cases td,.cases th{padding-right:5px}
.spark{width:60px}
.figures{grid-template-columns:1fr 1fr}
.figures.wide-figure{grid-template-columns:1fr}
details::details-content{content-visibility:visible;block-size:auto}
thead{display:table-header-group}
tr{break-inside:avoid}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}
}
)css";

}  // namespace

const char* page_style() { return style; }

}  // namespace ehd::report
