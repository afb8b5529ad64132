package org.starl.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Failures of libraries in StarL's words. */
class FailureTextTest {

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "my.Missing # gone | 'my.Missing': expected the name of a public class that is a Runnable",
        "org.starl.input.BadInput | 'org.starl.input.BadInput': expected",
        "two words | one of its lines: expected",
        "1st | '1st': expected"
      })
  void aBrokenServiceIsNamed(String entry, String problem) throws IOException {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve("java.lang.Runnable"), entry.strip() + "\n");
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
      assertThatThrownBy(() -> ServiceLoader.load(Runnable.class, loader).forEach(Runnable::run))
          .isInstanceOfSatisfying(
              ServiceConfigurationError.class,
              error ->
                  assertThat(FailureText.service(Runnable.class, error))
                      .hasMessageStartingWith(
                          "META-INF/services/java.lang.Runnable: " + problem.strip()));
    }
  }

  @Test
  void aFileInAnotherEncodingIsNoText() {
    assertThat(FailureText.of(new MalformedInputException(1))).isEqualTo("not text in UTF-8");
  }
}
