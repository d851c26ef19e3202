#!/usr/bin/python3
"""Writes the manual as Mallard pages, which Yelp and yelp-build read.

    mallard.py SOURCE-ROOT LANGUAGE OUT-FOLDER [ID=FILE.md]...

docs/manual/README.md names the pages: every list item there that links to a Markdown file makes it
a page, below the heading that it stands under. A page of docs/manual is replaced by the one of the
same name in the folder of the language, where there is one. ID=FILE.md are further pages that the
build has made; the list links to them as ID.md.
"""

import os
import re
import shutil
import sys
from xml.sax.saxutils import escape, quoteattr

from markdown_it import MarkdownIt

HOME = "https://github.com/quoin/quoin/blob/main/"
NAMESPACE = 'xmlns="http://projectmallard.org/1.0/"'


def page_id(path):
    """docs/manual/joints.md is "joints", docs/method/laws.md "method-laws"."""
    folder, name = os.path.split(path)
    stem = name.removesuffix(".md")
    room = os.path.basename(folder)
    if stem == "README":
        return "index" if room == "manual" else room
    return stem if room in ("manual", "docs", "data", "") else f"{room}-{stem}"


def anchor(heading):
    """What a heading is called in links, as on the web pages of the repository."""
    kept = re.sub(r"[^\w\- ]", "", heading.lower())
    return kept.replace(" ", "-")


def plain(inline):
    return "".join(t.content for t in inline.children if t.type in ("text", "code_inline"))


class Page:
    """One Markdown file and what it says of itself."""

    def __init__(self, manual, path, given=None):
        self.manual = manual
        self.path = manual.localised(path) if given is None else path
        self.id = page_id(path) if given is None else given
        # Links of a page that is made when building are those of a page of the manual.
        self.folder = os.path.dirname(self.path) if given is None else "docs/manual"
        with open(os.path.join(manual.root, self.path), encoding="utf-8") as file:
            self.tokens = manual.parser.parse(file.read())
        self.title = plain(self.tokens[1])
        self.guide = None
        self.description = None

    def target(self, link):
        """Attributes of a link, as Mallard writes them."""
        if "://" in link:
            return f"href={quoteattr(link)}"
        name, _, place = link.partition("#")
        path = self.manual.common(os.path.join(self.folder, name))
        page = self if not name else self.manual.pages.get(path)
        if page is None:
            return f"href={quoteattr(HOME + path)}"
        return f"xref={quoteattr(page.id + ('#' + place if place else ''))}"

    def picture(self, source):
        return self.manual.picture(os.path.normpath(os.path.join(os.path.dirname(self.path), source)))

    def inline(self, token):
        out = []
        for child in token.children:
            if child.type == "text":
                out.append(escape(child.content))
            elif child.type == "code_inline":
                out.append(f"<code>{escape(child.content)}</code>")
            elif child.type in ("softbreak", "hardbreak"):
                out.append("\n")
            elif child.type == "strong_open":
                out.append('<em style="strong">')
            elif child.type == "em_open":
                out.append("<em>")
            elif child.type in ("strong_close", "em_close"):
                out.append("</em>")
            elif child.type == "link_open":
                out.append(f"<link {self.target(child.attrGet('href'))}>")
            elif child.type == "link_close":
                out.append("</link>")
            elif child.type == "image":
                out.append(f'<media type="image" '
                           f"src={quoteattr(self.picture(child.attrGet('src')))}>"
                           f"<p>{escape(child.content)}</p></media>")
            elif child.type != "html_inline":
                raise ValueError(f"{self.path}: {child.type} is not converted")
        return "".join(out)

    def body(self):
        """The page without its title."""
        simple = {
            "bullet_list_open": "<list>", "bullet_list_close": "</list>",
            "ordered_list_open": "<steps>", "ordered_list_close": "</steps>",
            "list_item_open": "<item>", "list_item_close": "</item>",
            "blockquote_open": "<note>", "blockquote_close": "</note>",
            "table_open": '<table frame="top bottom" rules="rows" shade="rows">',
            "table_close": "</table>",
            "thead_open": "<thead>", "thead_close": "</thead>",
            "tbody_open": "<tbody>", "tbody_close": "</tbody>",
            "tr_open": "<tr>", "tr_close": "</tr>",
            "th_open": "<td><p>", "th_close": "</p></td>",
            "td_open": "<td><p>", "td_close": "</p></td>",
            "html_block": "",
        }
        out, levels, i = [], [], 3
        while i < len(self.tokens):
            token = self.tokens[i]
            if token.type == "heading_open":
                level = max(2, int(token.tag[1]))
                while levels and levels[-1] >= level:
                    out.append("</section>\n")
                    levels.pop()
                levels.append(level)
                title = self.tokens[i + 1]
                out.append(f"<section id={quoteattr(anchor(plain(title)))}>\n"
                           f"<title>{self.inline(title)}</title>\n")
                i += 2
            elif token.type == "paragraph_open":
                inside = self.tokens[i + 1]
                alone = len(inside.children) == 1 and inside.children[0].type == "image"
                text = self.inline(inside)
                out.append(text + "\n" if alone else f"<p>{text}</p>\n")
                i += 2
            elif token.type == "inline":
                out.append(self.inline(token))
            elif token.type in ("fence", "code_block"):
                kind = "screen" if token.info.startswith(("sh", "console")) else "code"
                out.append(f"<{kind}>{escape(token.content.rstrip())}</{kind}>\n")
            elif token.type in simple:
                out.append(simple[token.type])
            else:
                raise ValueError(f"{self.path}: {token.type} is not converted")
            i += 1
        out.append("</section>\n" * len(levels))
        return "".join(out)

    def mallard(self, order):
        about = f"<title type=\"sort\">{order:03d}</title>"
        if self.guide is not None:
            about += f"<link type=\"guide\" xref=\"index#{self.guide}\"/>"
        if self.description:
            about += f"<desc>{escape(self.description)}</desc>"
        return (f"<page {NAMESPACE} type=\"topic\" id={quoteattr(self.id)}>\n<info>{about}</info>\n"
                f"<title>{self.inline(self.tokens[1])}</title>\n{self.body()}</page>\n")


class Manual:
    def __init__(self, root, language, out, made):
        self.root, self.language, self.out = root, language, out
        self.parser = MarkdownIt("commonmark").enable("table")
        self.pages, self.sections = {}, []
        self.index = Page(self, "docs/manual/README.md")
        self.pages["docs/manual/README.md"] = self.index
        self.read_index(made)

    def common(self, path):
        """The path of a page, whatever the language of the one that links to it."""
        return os.path.normpath(path).replace(f"docs/manual/{self.language}/", "docs/manual/")

    def localised(self, path):
        folder, name = os.path.split(path)
        own = os.path.join(folder, self.language, name)
        return own if os.path.exists(os.path.join(self.root, own)) else path

    def picture(self, path):
        """Copies a picture beside the pages."""
        name = path.replace("/", "-")
        folder = os.path.join(self.out, "figures")
        os.makedirs(folder, exist_ok=True)
        shutil.copy(os.path.join(self.root, path), os.path.join(folder, name))
        return "figures/" + name

    def read_index(self, made):
        tokens = self.index.tokens
        for i, token in enumerate(tokens):
            if token.type == "heading_open" and token.tag == "h2":
                self.sections.append((f"part{len(self.sections) + 1}", tokens[i + 1]))
            if token.type != "list_item_open":
                continue
            inline = tokens[i + 2]
            link = inline.children[0].attrGet("href")
            path = self.common(os.path.join(os.path.dirname(self.index.path), link))
            given = made.get(os.path.basename(link).removesuffix(".md"))
            page = (Page(self, path) if given is None
                    else Page(self, given, os.path.basename(link).removesuffix(".md")))
            page.guide = self.sections[-1][0]
            page.description = plain(inline).partition(": ")[2].replace("\n", " ")
            self.pages[path] = page

    def write(self):
        os.makedirs(self.out, exist_ok=True)
        text = [f'<page {NAMESPACE} type="guide" id="index">\n<title>{escape(self.index.title)}</title>\n']
        if self.index.tokens[3].type == "paragraph_open":
            text.append(f"<p>{self.index.inline(self.index.tokens[4])}</p>\n")
        for name, title in self.sections:
            text.append(f'<section id="{name}">\n<title>{escape(plain(title))}</title>\n</section>\n')
        self.save("index", "".join(text) + "</page>\n")
        for order, page in enumerate(self.pages.values()):
            if page is not self.index:
                self.save(page.id, page.mallard(order))

    def save(self, name, text):
        with open(os.path.join(self.out, name + ".page"), "w", encoding="utf-8") as file:
            file.write('<?xml version="1.0" encoding="utf-8"?>\n' + text)


def main():
    root, language, out, *made = sys.argv[1:]
    shutil.rmtree(out, ignore_errors=True)
    Manual(root, language, out, dict(item.split("=", 1) for item in made)).write()


main()
