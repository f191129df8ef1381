"""Every string of the program is translated into every language, and no translation is left of strings that are gone.

Usage: translated_strings_test.py LUPDATE. Collects the strings afresh and compares them with the languages'
translations/bask_*.ts, which tests/app/translations_test.cpp checks entry by entry.
"""

import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = {"fr": 2, "zh_CN": 1, "zh_TW": 1}  # forms of the plural


def messages(path):
    contexts = ElementTree.parse(path).getroot().findall("context")
    return {(context.findtext("name"), message.findtext("source"), message.findtext("comment")): message
            for context in contexts for message in context.findall("message")}


def collected(lupdate):
    sources = [path for folder in ("app", "widgets") for path in sorted((ROOT / folder).rglob("*.[hc]*"))
               if path.suffix in (".h", ".cpp")]
    sources += [path for path in sorted((ROOT / "engine").rglob("*"))
                if path.suffix in (".cpp", ".h") and "QT_TRANSLATE_NOOP" in path.read_text()]
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "fresh.ts"
        subprocess.run([lupdate, "-silent", "-I", ROOT, *sources, "-ts", fresh], check=True, stderr=subprocess.DEVNULL)
        return messages(fresh)


def is_whole(message, forms):
    translation = message.find("translation")
    if translation is None or "type" in translation.attrib:
        return False
    if message.get("numerus") != "yes":
        return bool(translation.text)
    return len(translation) == forms and all(form.text for form in translation)


found = collected(sys.argv[1])
assert len(found) > 500, f"only {len(found)} strings were found"
wrong = []
for language, forms in LANGUAGES.items():
    translated = messages(ROOT / f"translations/bask_{language}.ts")
    for key in found:
        if key not in translated:
            wrong.append(f"{language}: not translated: {key}")
        elif (found[key].get("numerus") != translated[key].get("numerus")
              or not is_whole(translated[key], forms)):
            wrong.append(f"{language}: unfinished: {key}")
    wrong += [f"{language}: translation of a string that is gone: {key}" for key in translated if key not in found]
for line in sorted(wrong):
    print(line)
sys.exit(bool(wrong))
