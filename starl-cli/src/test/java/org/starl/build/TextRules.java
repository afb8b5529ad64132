package org.starl.build;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;

/** What every file of the project keeps to, whatever language it is in. */
final class TextRules {

  private static final int LONG_FILE_LINES = 500;
  private static final int HEAD_LINES = 40;
  private static final String SAMPLE = "docs/sample.md";

  private TextRules() {}

  static List<Rule> all() {
    return List.of(
        text("trailing whitespace", "none", "[ \\t]+$", "word "),
        new Rule(
            "tab",
            "spaces",
            file -> file.isCode() || file.path().endsWith(".kts") || file.path().endsWith(".xml"),
            Rule.anywhere("\\t"),
            new SourceFile("starl-core/pom.xml", "\t<x/>")),
        new Rule(
            "no newline at the end",
            "end the last line",
            any(),
            file ->
                file.text().isEmpty() || file.text().endsWith("\n")
                    ? List.of()
                    : List.of(file.lines().size()),
            new SourceFile(SAMPLE, "word")),
        text(
            "a reminder of work that is left",
            "do it, or say in the docs what is not there yet",
            "\\b(TODO|FIXME|XXX)\\b",
            "// TODO later"),
        text(
            "a path of somebody's machine",
            "a path from the project's root, or a temporary folder that the program asks for",
            "(?<![\\w.])(/w[o]rk/|/root/|/home/\\w|/Users/\\w|/tmp/|[A-Z]:\\\\\\\\?Users)",
            "see /home/me/starl"),
        text(
            "a registry's host",
            "nothing: each machine's own settings name it",
            "(?i)repo1?\\.maven\\.(org|apache\\.org)|registry\\.npmjs|pypi\\.org|pythonhosted"
                + "|plugins\\.gradle\\.org|artifactory|\\bnexus\\b",
            "https://repo1.maven.org/maven2"),
        text(
            "words about how the project is made",
            "speak of the project alone",
            "(?i)\\bhelper agents?\\b|\\bAI (assistant|agent)s?\\b|\\blanguage models?\\b"
                + "|\\bthe issue\\b|\\bissue #?[0-9]|\\bdesign document\\b|\\bdesign\\.md\\b"
                + "|co-authored-by",
            "as the design document has it"),
        new Rule(
            "a file of over " + LONG_FILE_LINES + " lines that does not say why",
            "split it, or open it with a comment: 'Longer than "
                + LONG_FILE_LINES
                + " lines because ...'",
            file -> file.isCode() || file.path().equals("starl") || file.path().startsWith(".ci/"),
            TextRules::unexplainedLength,
            new SourceFile("starl-core/src/main/java/org/starl/Sample.java", "\n".repeat(501))),
        new Rule(
            "a package-info that does not do its work",
            "open with what the package is for, end with 'May import: ...', mark it @NullMarked",
            file -> file.isMain() && file.path().endsWith("/package-info.java"),
            TextRules::lacksOfPackageInfo,
            new SourceFile("a/src/main/java/a/package-info.java", "/** For b. */\npackage a;\n")));
  }

  private static Rule text(String name, String instead, String regex, String wrong) {
    return new Rule(name, instead, any(), Rule.anywhere(regex), new SourceFile(SAMPLE, wrong));
  }

  private static Predicate<SourceFile> any() {
    return file -> true;
  }

  private static List<Integer> unexplainedLength(SourceFile file) {
    List<String> lines = file.lines();
    if (lines.size() <= LONG_FILE_LINES) {
      return List.of();
    }
    String head = String.join(" ", lines.subList(0, HEAD_LINES));
    return head.contains("Longer than " + LONG_FILE_LINES + " lines because")
        ? List.of()
        : List.of(lines.size());
  }

  private static List<Integer> lacksOfPackageInfo(SourceFile file) {
    boolean isWhole =
        file.text().startsWith("/**")
            && file.text().contains("May import: ")
            && file.text().contains("@NullMarked");
    return isWhole ? List.of() : List.of(1);
  }

  /** Packages of shipped Java that have no package-info, in any module. */
  static Set<String> packagesWithoutInfo(List<SourceFile> files) {
    Set<String> without = new TreeSet<>();
    Set<String> with = new TreeSet<>();
    for (SourceFile file : files) {
      if (file.isMain() && file.isJava()) {
        int end = file.path().lastIndexOf('/');
        String name = file.path().substring(file.path().indexOf("java/"), end);
        (file.path().endsWith("/package-info.java") ? with : without).add(name);
      }
    }
    without.removeAll(with);
    return without;
  }
}
