package org.starl.robot.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.robot.file.Node.Listing;
import org.starl.robot.file.Node.Mapping;
import org.starl.robot.file.Node.Text;

class YamlTreeTest {

  private static Node read(String text) {
    return YamlTree.read("my.yaml", text);
  }

  private static void assertRefused(String text, String line) {
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(DeploymentException.class)
        .hasMessage("my.yaml:" + line);
  }

  @Test
  void valuesListsAndLinesBeneathHaveTheirLines() {
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
  void whatStandsForNothingIsEmptyUnlessItIsQuoted() {
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
  void whatIsNoYamlIsToldWithItsLine() {
    assertRefused(
        "app: hello\n  robots: x: y", "2: is no YAML; expected lines such as 'app: intersection'");
  }

  @Test
  void whatAFileMayNotHaveIsTold() {
    assertRefused("app: hello\napp: hello", "2: app: expected once, stands there again");
    assertRefused("app: hello\n---\napp: more", "3: expected one document");
    assertRefused("app: *b", "1: app: expected one value, or lines beneath");
    assertRefused("- a", "1: expected lines such as 'app: intersection'");
    assertRefused("", "1: expected lines such as 'app: intersection'");
  }

  @Test
  void noTextMakesTheReaderFailOtherwise() {
    String deep = "a: " + "[".repeat(100_000);
    for (String text :
        new String[] {"", "- a", "a", "a: *b", "a: \0", "? {b: c} : d", "%YAML 9", deep}) {
      assertThatThrownBy(() -> read(text)).isInstanceOf(DeploymentException.class);
    }
  }
}
