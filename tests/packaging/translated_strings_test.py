"""Every string of the program has its French, and no French is left of strings that are gone.

Usage: translated_strings_test.py LUPDATE. Collects the strings afresh and compares them with
translations/bask_fr.ts, which tests/app/translations_test.cpp checks entry by entry.
"""

import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def strings(path):
    contexts = ElementTree.parse(path).getroot().findall("context")
    return {(context.findtext("name"), message.findtext("source"))
            for context in contexts for message in context.findall("message")}


def collected(lupdate):
    sources = [path for folder in ("app", "widgets") for path in sorted((ROOT / folder).rglob("*.[hc]*"))
               if path.suffix in (".h", ".cpp")]
    sources.append(ROOT / "engine/base/message.cpp")
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "fresh.ts"
        subprocess.run([lupdate, "-silent", "-I", ROOT, *sources, "-ts", fresh], check=True, stderr=subprocess.DEVNULL)
        return strings(fresh)


found, french = collected(sys.argv[1]), strings(ROOT / "translations/bask_fr.ts")
assert len(found) > 500, f"only {len(found)} strings were found"
for context, source in sorted(found - french):
    print(f"{context}: no French: {source}")
for context, source in sorted(french - found):
    print(f"{context}: French of a string that is gone: {source}")
sys.exit(found != french)
