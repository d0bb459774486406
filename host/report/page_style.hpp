// SPDX-License-Identifier: MIT
// How a page looks: light and dark as the reader's system is, on paper as on a screen. The colours of series are those
// of figure.hpp, on a dark ground in lighter shades that can be told apart as well.
#pragma once

#include "report/html.hpp"

namespace regista::report {

inline constexpr Markup page_style = R"(
:root{color-scheme:light dark;--background:#fff;--ink:#1b1f24;--soft:#59636e;--line:#d8dde3;--panel:#f5f7f9;--grid:#d5dae0;
--series-1:#0072b2;--series-2:#d55e00;--series-3:#009e73;--series-4:#cc79a7;--series-5:#e69f00;--series-6:#56b4e9;
--series-7:#000;--series-8:#7f7f7f;--link:#005a8f}
@media (prefers-color-scheme:dark){:root{--background:#15181c;--ink:#e6e9ec;--soft:#9aa4ae;--line:#343b43;--panel:#1d2126;
--grid:#363d45;--series-1:#56b4e9;--series-2:#f0913a;--series-3:#2fc79b;--series-4:#e3a3c6;--series-5:#f0e442;
--series-6:#3f8fd0;--series-7:#e6e9ec;--series-8:#9a9a9a;--link:#7cc4f0}}
*{box-sizing:border-box}
body{margin:0;background:var(--background);color:var(--ink);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,
"Helvetica Neue",Arial,sans-serif;font-variant-numeric:tabular-nums}
main{max-width:1180px;margin:0 auto;padding:22px 24px 60px}
a{color:var(--link)}
.kicker{margin:0;color:var(--soft);font-size:14px}
h1{margin:2px 0 8px;font-size:30px;line-height:1.2;font-weight:650;letter-spacing:-.01em;text-wrap:balance;
overflow-wrap:anywhere}
.beside{margin:0;color:var(--soft);max-width:92ch;overflow-wrap:anywhere}
h2{margin:38px 0 10px;padding-top:14px;border-top:1px solid var(--line);font-size:19px;line-height:1.3}
h3{margin:18px 0 6px;font-size:15px}
p{margin:6px 0;max-width:92ch}
.note{color:var(--soft);font-size:13.5px}
.tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:10px;margin:18px 0 14px}
.tile{background:var(--panel);border:1px solid var(--line);border-radius:8px;padding:9px 13px 8px;min-width:0}
.tile b{display:block;font-size:21px;line-height:1.25;font-weight:620;overflow-wrap:anywhere}
.tile span{display:block;color:var(--soft);font-size:13px;line-height:1.35}
.wide{overflow-x:auto;margin:8px 0}
table{border-collapse:collapse;font-size:14px;line-height:1.4}
th{text-align:left;font-weight:600;color:var(--soft);font-size:13px;vertical-align:bottom}
th,td{padding:4px 16px 4px 0;border-bottom:1px solid var(--line)}
td{vertical-align:top}
.n{text-align:right}td.n{white-space:nowrap}
bdi{overflow-wrap:anywhere}
table bdi{display:inline-block;max-width:34ch;overflow-wrap:break-word}
.two{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:26px}
@media (max-width:880px){.two{grid-template-columns:minmax(0,1fr)}}
figure{margin:10px 0 0;min-width:0;max-width:640px}
.full figure,.full figcaption{max-width:none}
figure svg{display:block;width:100%;height:auto;font-family:inherit}
figcaption{font-size:13.5px;color:var(--soft);max-width:80ch;overflow-wrap:anywhere}
figcaption b{color:var(--ink)}
.take{white-space:nowrap}
#doubts p::first-letter,#remarks p::first-letter{text-transform:uppercase}
.key{display:inline-block;width:10px;height:10px;margin-right:6px;background:var(--series-1)}
.first{border-radius:50%}.second{background:var(--series-2);clip-path:polygon(50% 0,100% 100%,0 100%)}
pre{margin:6px 0;padding:10px 12px;background:var(--panel);border:1px solid var(--line);border-radius:6px;
font:12.5px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;white-space:pre-wrap;overflow-wrap:anywhere;
max-height:60vh;overflow:auto}
code{font:12.5px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;overflow-wrap:anywhere}
td code{white-space:pre-wrap}
.values td{min-width:9ch;max-width:34ch;overflow-wrap:anywhere}.values td:first-child{min-width:24ch;max-width:64ch}
.path{overflow-wrap:normal}
.tight table{font-size:13px}.tight th{font-size:12.5px}.tight th,.tight td{padding-right:10px}
.heat td{border-bottom-color:var(--background)}.heat td.n{padding:4px 9px}
.heat td span{display:block;margin:-4px -9px;padding:4px 9px}
.differs{font-weight:620}
details{margin:8px 0}summary{cursor:pointer}
footer{margin-top:40px;color:var(--soft);font-size:13px}
@media print{:root{color-scheme:light}main{max-width:none;padding:0}body{font-size:11pt}h1{font-size:20pt}
h2{break-after:avoid}figure,tr,.tile,.tiles{break-inside:avoid}pre{max-height:none}.take{display:none}}
)"_html;

}  // namespace regista::report
