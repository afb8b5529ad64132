package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** No source holds what the project does without, but for the listed allowances. */
class TidyTest {

  private static final List<SourceFile> FILES = Repository.here().textFiles();

  private static final List<Rule.Finding> FINDINGS =
      FILES.stream().flatMap(file -> rules().flatMap(r -> r.findings(file).stream())).toList();

  static Stream<Rule> rules() {
    return Stream.concat(CodeRules.all().stream(), TextRules.all().stream());
  }

  @Test
  void everySourceIsTidy() {
    List<Rule.Finding> notAllowed =
        FINDINGS.stream()
            .filter(finding -> Allowance.all().stream().noneMatch(a -> a.covers(finding)))
            .toList();
    assertThat(notAllowed).isEmpty();
  }

  @Test
  void everyAllowanceIsNeeded() {
    assertThat(Allowance.all())
        .allSatisfy(a -> assertThat(FINDINGS).as("needed for").anyMatch(a::covers));
  }

  @Test
  void everyPackageSaysWhatItIsFor() {
    assertThat(TextRules.packagesWithoutInfo(FILES)).isEmpty();
  }

  @Test
  void theTreeIsReadWhole() {
    assertThat(FILES).extracting(SourceFile::path).contains("starl", "pom.xml", "README.md");
    assertThat(FILES).filteredOn(SourceFile::isMain).hasSizeGreaterThan(100);
    assertThat(FILES).extracting(SourceFile::path).noneMatch(path -> path.contains("/target/"));
  }

  @ParameterizedTest
  @MethodSource("rules")
  void everyRuleFindsWhatIsWrong(Rule rule) {
    assertThat(rule.findings(rule.wrong())).isNotEmpty();
  }

  @Test
  void aPackageWithoutInfoIsFound() {
    SourceFile alone = new SourceFile("starl-core/src/main/java/org/starl/alone/A.java", "");
    assertThat(TextRules.packagesWithoutInfo(List.of(alone))).hasSize(1);
  }

  @Test
  void commentsAndLiteralsAreNotCode() {
    String text = "f(\"a // b\\\" c\"); // g\n/* h\n*/ i('\"', \"\"\"\n  j\"\n  \"\"\");\n";
    String code = JavaText.codeOf(text);
    assertThat(code).hasSameSizeAs(text).contains("f(\"").contains("i('");
    assertThat(code.lines()).hasSameSizeAs(text.lines().toList());
    assertThat(code).doesNotContain("a", "b", "c", "g", "h", "j");
  }
}
