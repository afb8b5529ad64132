package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.input.BadInput;

/** The ranges on an app's page and in its help are those that its code accepts. */
class RangesTest {

  private static final int TOO_MANY = 1_000_000;
  private static final Pattern RANGE = Pattern.compile("\\b(\\d+) to (\\d+)(?=[\\s,;:(]|$)");

  static List<String> apps() {
    return Main.APPS.names();
  }

  private static String page(Demo demo) throws IOException {
    return Files.readString(Path.of("../docs/apps/" + demo.name() + ".md"));
  }

  private static void plan(Demo demo, String key, String value) {
    RunRequest.Builder request = new RunRequest.Builder(demo);
    request.set("", key, value);
    request.build().plan(1);
  }

  @ParameterizedTest
  @MethodSource("apps")
  void thePageTellsHowManyRobotsTheAppTakes(String app) throws IOException {
    Demo demo = Main.APPS.byName(app).orElseThrow();
    Throwable refused = catchThrowable(() -> plan(demo, "robots", String.valueOf(TOO_MANY)));
    // The floor limits the robots of an app that names no range.
    Matcher range = RANGE.matcher(refused == null ? "" : String.valueOf(refused.getMessage()));
    if (range.find()) {
      int most = Integer.parseInt(range.group(2));
      String text = String.format(Locale.ROOT, "1 to %,d", most);
      assertThat(page(demo)).containsPattern(text + " (robots|painters|cars)");
    }
  }

  @ParameterizedTest
  @MethodSource("apps")
  void thePageTheHelpAndTheCodeHaveOneRangeForEachParameter(String app) throws IOException {
    Demo demo = Main.APPS.byName(app).orElseThrow();
    for (Parameter parameter : demo.parameters()) {
      Matcher range = RANGE.matcher(parameter.what());
      if (range.find()) {
        String key = parameter.key();
        String row =
            page(demo).lines().filter(l -> l.startsWith("| `" + key + "`")).findFirst().orElse("");
        assertThat(row).as(app + ", " + key).contains(range.group());
        int most = Integer.parseInt(range.group(2));
        assertThatCode(() -> plan(demo, key, String.valueOf(most))).doesNotThrowAnyException();
        for (int outside : List.of(Integer.parseInt(range.group(1)) - 1, most + 1)) {
          assertThatThrownBy(() -> plan(demo, key, String.valueOf(outside)))
              .as(app + ", " + key + "=" + outside)
              .isInstanceOf(BadInput.class);
        }
      }
    }
  }
}
