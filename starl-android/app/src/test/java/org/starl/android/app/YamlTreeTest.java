package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.deploy.file.Deployment;
import org.starl.deploy.file.DeploymentException;
import org.starl.deploy.file.DeploymentReader;
import org.starl.deployment.DeploymentFile;
import org.starl.sim.input.BadInput;

/** A phone reads deployments as everybody does. */
class YamlTreeTest {

  private static final Path EXAMPLE = Path.of("../../scenarios/deployment/crossing.yaml");

  @TempDir private Path folder;

  private static Deployment onPhone(String file, String text) {
    return DeploymentReader.read(file, YamlTree.read(file, text));
  }

  @Test
  void theShippedDeploymentIsTheSameOnAPhoneLinesIncluded() throws IOException {
    String file = EXAMPLE.toString();
    assertThat(onPhone(file, Files.readString(EXAMPLE))).isEqualTo(DeploymentFile.read(file));
  }

  @Test
  void whatIsNoYamlIsToldWithItsLine() {
    assertThatThrownBy(() -> YamlTree.read("my.yaml", "app: hello\n  robots: x: y"))
        .isInstanceOf(DeploymentException.class)
        .hasMessage("my.yaml:2: is no YAML; expected lines such as 'app: intersection'");
  }

  @Test
  void noTextMakesTheReaderFailOtherwise() {
    for (String text : new String[] {"", "- a", "a", "a: *b", "a: \0", "? {b: c} : d", "%YAML 9"}) {
      assertThatThrownBy(() -> YamlTree.read("my.yaml", text))
          .isInstanceOf(DeploymentException.class);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "app: hello\nrobots: [bot0]",
        "app: hello\napp: hello",
        "app: hello\nport: 1\n---\napp: more",
        "app: {}"
      })
  void aPhoneRefusesWithTheWordsOfEverybody(String text) throws IOException {
    Path file = folder.resolve("my.yaml");
    Files.writeString(file, text);
    String told = refusalOf(file);
    assertThatThrownBy(() -> onPhone(file.toString(), Files.readString(file))).hasMessage(told);
  }

  private static String refusalOf(Path file) {
    try {
      DeploymentFile.read(file.toString());
      throw new AssertionError("taken: " + file);
    } catch (BadInput e) {
      return e.getMessage();
    }
  }
}
