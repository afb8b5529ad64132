package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.command.Apps;
import org.starl.cli.request.RunRequest;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantity;

/** The ranges on an app's page, in its help and in its code are those of its parameters' forms. */
class RangesTest {

  private static final int TOO_MANY = 1_000_000;
  private static final Pattern RANGE = Pattern.compile("\\b(\\d+) to (\\d+)(?=[\\s,;:(]|$)");

  static List<String> apps() {
    return Apps.OWN.names();
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
    Demo demo = Apps.OWN.byName(app).orElseThrow();
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
  void thePageHasTheRangeOfEachParameter(String app) throws IOException {
    Demo demo = Apps.OWN.byName(app).orElseThrow();
    for (Parameter parameter : demo.parameters()) {
      Matcher range =
          Pattern.compile("from (\\S+ to \\S+)$").matcher(Form.expected(parameter.form()));
      if (range.find()) {
        String key = "| `" + parameter.key() + "`";
        String row = page(demo).lines().filter(l -> l.startsWith(key)).findFirst().orElse("");
        assertThat(row).as(app + ", " + key).contains(range.group(1));
      }
    }
  }

  /** Whether the app reads it or not: drawn=200 is refused although the points are those of a file. */
  @ParameterizedTest
  @MethodSource("apps")
  void aValueOutsideItsFormIsRefused(String app) {
    Demo demo = Apps.OWN.byName(app).orElseThrow();
    for (Parameter parameter : demo.parameters()) {
      if (!(parameter.form() instanceof Form.Text)) {
        assertThatThrownBy(() -> plan(demo, parameter.key(), "erly"))
            .as(app + ", " + parameter.key())
            .isInstanceOf(BadInput.class)
            .hasMessageStartingWith(parameter.key() + ": 'erly': expected ");
      }
    }
  }

  @Test
  void aScenarioFilesValueIsRefusedByItsFormAlone() {
    Cli.run(new Demos(List.of(new Careless())), "run careless --set when=erly".split(" "))
        .assertRefused("when: 'erly': expected one of early, late");
    Cli.run(new Demos(List.of(new Careless())), "run careless --set far=20m".split(" "))
        .assertRefused("far: '20m': expected a distance from 1m to 10m");
    Cli list = Cli.run(new Demos(List.of(new Careless())), "list", "careless");
    assertThat(list.text())
        .contains("when it begins; one of early, late")
        .contains("how far it goes; a distance from 1m to 10m");
  }

  /** Declares parameters, and forgets to check them. */
  private static final class Careless extends HelloWithATwist {
    Careless() {
      super("careless", "an app that reads nothing");
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(
          new Parameter("when", "late", "when it begins", Form.choice(List.of("early", "late"))),
          new Parameter(
              "far", "2m", "how far it goes", Form.between(Quantity.DISTANCE, "1m", "10m")));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      return plan;
    }
  }
}
