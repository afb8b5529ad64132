package org.starl.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.input.Node.Listing;
import org.starl.input.Node.Mapping;
import org.starl.input.Node.Text;

class DocumentReaderTest {

  private static final String EXPECTED = "expected lines such as 'app: intersection'";

  private static Node read(String text) {
    return DocumentReader.read("my.yaml", text, EXPECTED);
  }

  private static void assertRefused(String text, String line) {
    assertThatThrownBy(() -> read(text)).isInstanceOf(BadInput.class).hasMessage("my.yaml:" + line);
  }

  @Test
  void valuesListsAndMappingsHaveTheirLines() {
    assertThat(read("app: hello\nfaults: [a, b]\nnetwork:\n  port: 1\n"))
        .isEqualTo(
            new Mapping(
                1,
                Map.of(
                    "app", new Text(1, "hello"),
                    "faults", new Listing(2, List.of(new Text(2, "a"), new Text(2, "b"))),
                    "network", new Mapping(3, Map.of("port", new Text(4, "1"))))));
  }

  @Test
  void jsonIsYamlToo() {
    assertThat(read("{\"app\": \"hello\",\n \"faults\": [\"a\"], \"port\": 1}"))
        .isEqualTo(
            new Mapping(
                1,
                Map.of(
                    "app", new Text(1, "hello"),
                    "faults", new Listing(2, List.of(new Text(2, "a"))),
                    "port", new Text(2, "1"))));
  }

  @Test
  void valuesKeepTheTextThatWasWritten() {
    assertThat(read("{a: 007, b: 1_000, c: 1e2, d: .5, e: yes, f: 0x1p3, g: 2026-01-01, h: 4.10}"))
        .isEqualTo(
            new Mapping(
                1,
                Map.of(
                    "a", new Text(1, "007"),
                    "b", new Text(1, "1_000"),
                    "c", new Text(1, "1e2"),
                    "d", new Text(1, ".5"),
                    "e", new Text(1, "yes"),
                    "f", new Text(1, "0x1p3"),
                    "g", new Text(1, "2026-01-01"),
                    "h", new Text(1, "4.10"))));
  }

  @Test
  void nullIsEmptyUnlessItIsQuoted() {
    assertThat(read("{a: , b: ~, c: null, d: 'null', e: '~'}"))
        .isEqualTo(
            new Mapping(
                1,
                Map.of(
                    "a", new Text(1, ""),
                    "b", new Text(1, ""),
                    "c", new Text(1, ""),
                    "d", new Text(1, "null"),
                    "e", new Text(1, "~"))));
  }

  @Test
  void textThatIsNotYamlIsRefusedWithItsLine() {
    String expected = "; expected lines such as 'app: intersection'";
    assertRefused(
        "app: hello\n  robots: x: y", "2: is not YAML at character 9, ': x: y'" + expected);
    assertRefused(
        "app: hello\nset:\n\trobots: 2",
        "3: begins with a tab: expected blanks to indent, as YAML has no tabs" + expected);
    assertRefused("app: hello\nset: \"x", "2: is not YAML at the end of this line" + expected);
    assertRefused(
        "app:\thello",
        "1: has a tab at character 5: expected blanks to separate words, as YAML has no tabs there"
            + expected);
    assertRefused("app: hello\nset: \u0007x", "2: is not YAML at character 6, '?x'" + expected);
    assertRefused("app: hello\nset: x\u0007", "2: is not YAML at character 7, '?'" + expected);
    assertRefused("# none\n", "1: " + EXPECTED);
  }

  /** Names of files may not hold it, and errors about them would not be in our words. */
  @Test
  void aZeroInAValueIsRefused() {
    String expected = "expected a text without the character zero";
    assertRefused("a: 1\nb: \"x\\0y\"", "2: b: 'x?y': " + expected);
    assertRefused("a: 1\n\"b\\0\": 1", "2: 'b?': " + expected);
  }

  @Test
  void duplicateKeysSeveralDocumentsAliasesAndListsAreRefused() {
    assertRefused("app: hello\napp: hello", "2: app: expected this key once");
    assertRefused("app: hello\n---\napp: more", "3: expected one document");
    assertRefused("a: &x 1\nb: *x", "2: b: '*x': expected the value itself, without an alias");
    assertRefused("a: 1\nb: !!binary AAAA", "2: b: expected one value, a list or a mapping");
    assertRefused("- a", "1: " + EXPECTED);
    assertRefused("", "1: " + EXPECTED);
  }

  @Test
  void tagsThatYamlDoesNotHaveAreRefused() {
    assertRefused("a: 1\nb: !degrees 45", "2: b: the tag '!degrees': expected a value without it");
    assertRefused("a:\n  - !x {b: 1}", "2: a: the tag '!x': expected a value without it");
    assertRefused("a: !list [1]", "1: a: the tag '!list': expected a value without it");
    assertThat(read("a: !!str 007\nb: !!int 7\nc: ! x").toString()).contains("007", "7", "x");
  }

  @Test
  void aTextThatIsTooLongIsNamedAsSuch() {
    StringBuilder text = new StringBuilder("app: hello\n");
    for (int i = 0; text.length() <= 3_000_000; i++) {
      text.append("key").append(i).append(": 1\n");
    }
    assertThatThrownBy(() -> read(text.toString()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(": is longer than 3000000 characters; ");
  }

  @Test
  void everyOtherTextIsRefusedAsBadInput() {
    String deep = "a: " + "[".repeat(100_000);
    String huge = "a: " + "b".repeat(4_000_000);
    for (String text :
        new String[] {
          "",
          "- a",
          "a",
          "a: *b",
          "a: \0",
          "? {b: c} : d",
          "%YAML 9",
          "a: !!int +",
          "a: [!!int +",
          "a: !!binary '%'",
          deep,
          huge
        }) {
      assertThatThrownBy(() -> read(text)).isInstanceOf(BadInput.class);
    }
  }
}
