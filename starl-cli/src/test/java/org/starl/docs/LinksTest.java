package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What a page links to is there, and each page is in the site. */
class LinksTest {

  private static final Path ROOT = Path.of("..");
  private static final Pattern LINK = Pattern.compile("\\]\\((?!https?:|#)([^)#\\s]+)[^)]*\\)");

  static List<Path> pages() throws IOException {
    try (Stream<Path> top = Files.list(ROOT);
        Stream<Path> docs = Files.walk(ROOT.resolve("docs"))) {
      return Stream.concat(top, docs)
          .filter(path -> path.getFileName().toString().endsWith(".md"))
          .sorted()
          .toList();
    }
  }

  @Test
  void everyPageOfDocsIsInTheNavigationOfTheSite() throws IOException {
    Path docs = ROOT.resolve("docs");
    assertThat(
            Files.readAllLines(ROOT.resolve(".ci/site/mkdocs.yml")).stream()
                .map(line -> line.strip().replace("- ", "")))
        .containsAll(
            pages().stream()
                .filter(page -> page.startsWith(docs))
                .map(page -> docs.relativize(page).toString())
                .toList());
  }

  @ParameterizedTest
  @MethodSource("pages")
  void everyFileThatAPageLinksExists(Path page) throws IOException {
    assertThat(LINK.matcher(Files.readString(page)).results().map(match -> match.group(1)).toList())
        .allSatisfy(link -> assertThat(page.resolveSibling(link)).exists());
  }
}
