package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.report.Report;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/** {@code starl campaign --shrink}. */
class ShrinkingTest {

  private static final Demos FRAGILE = new Demos(List.of(new Fragile()));

  @TempDir private Path folder;

  /** Hello, of which three robots bear no wheels that are stuck. */
  private static final class Fragile extends HelloWithATwist {
    Fragile() {
      super("fragile", "hello that must not be stuck");
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(new Parameter("least", "3", "robots that are fragile"));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      int least = Integer.parseInt(request.parameter("least"));
      plan.simulation().monitor(() -> new NeverStuck(least));
      return plan;
    }
  }

  /** Always four robots, whatever the user asks for. */
  private static final class OfFour extends HelloWithATwist {
    OfFour() {
      super("of-four", "four robots that must not be stuck");
    }

    @Override
    public Plan plan(Request request, SimSettings settings) {
      return super.plan(
          new Request(request.seed(), OptionalInt.of(4), request.parameters()),
          settings.with(Setting.ROBOTS, 4));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation().monitor(() -> new NeverStuck(1));
      return plan;
    }
  }

  private static final class NeverStuck implements Monitor {
    private final int least;
    private int robots;

    NeverStuck(int least) {
      this.least = least;
    }

    @Override
    public List<String> lemmas() {
      return List.of("never_stuck");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      robots += event instanceof TraceEvent.Joined ? 1 : 0;
      if (event instanceof TraceEvent.Fault fault
          && fault.name().equals(TraceEvent.Fault.BEGIN)
          && fault.detail().startsWith("stuck")
          && robots >= least) {
        report.violated("never_stuck", event.timeNs(), List.of(event.robot()), fault.detail());
      }
    }
  }

  private Cli paste(String line) {
    List<String> words = new ArrayList<>();
    Matcher word =
        Pattern.compile("'([^']*)'|\\S+").matcher(line.substring("replay: ./starl ".length()));
    while (word.find()) {
      words.add(word.group(1) == null ? word.group() : word.group(1));
    }
    words.addAll(List.of("--png", folder.resolve("replay.png").toString()));
    return Cli.run(FRAGILE, words.toArray(String[]::new));
  }

  private static String last(List<String> lines, String beginning) {
    return lines.stream().filter(l -> l.startsWith(beginning)).reduce((a, b) -> b).orElseThrow();
  }

  /** Without the campaign's progress, which depends on the machine. */
  private static List<String> shrinking(Cli cli) {
    return cli.err().subList(cli.err().indexOf(first(cli.err(), "shrink 1: ")), cli.err().size());
  }

  private static String first(List<String> lines, String beginning) {
    return lines.stream().filter(l -> l.startsWith(beginning)).findFirst().orElseThrow();
  }

  @Test
  void aChaosRunShrinksToItsOneRelevantFault() {
    String[] args =
        "campaign fragile --seeds 1..8 --robots 6 --loss 0.1 --chaos --shrink".split(" ");
    Cli cli = Cli.run(FRAGILE, args);
    assertThat(cli.status()).as("%s", cli).isEqualTo(1);
    assertThat(cli.err()).anyMatch(line -> line.matches("shrink 1: 6 robots, 1 setting, .*"));
    String replay = last(cli.err(), "replay: ");
    assertThat(replay)
        .matches(
            "replay: \\./starl run fragile --seed \\d --robots 3 --for \\d+(ms|s)"
                + " --fault 'stuck\\([^']*\\)'");
    assertThat(last(cli.err(), "shrunk in ")).matches(".* -> 3 robots, 1 fault, \\d+(ms|s)");
    String violation = last(cli.err(), "seed ");
    String cause = last(cli.err(), "cause: stuck(");
    Cli twin = paste("replay: " + cause.substring(cause.indexOf("./starl run ")));
    assertThat(twin.status()).as("%s", twin).isZero();
    Cli again = paste(replay);
    assertThat(again.status()).isEqualTo(1);
    assertThat(again.out()).contains("VIOLATED: " + violation.replaceFirst("seed \\d+: ", ""));
    assertThat(Cli.run(FRAGILE, args).err()).containsSubsequence(shrinking(cli));
  }

  @Test
  void aScenarioFileShrinksToACommandWithoutIt() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("my.yaml"),
            "app: fragile\nrobots: 4\nleast: 2\nspeedError: 0.05\n"
                + "faults: [\"stuck(bot1,at=2s,for=3s)\", \"noise(all,9mm)\", \"slow(any,0.5)\"]\n");
    Cli cli =
        Cli.run(FRAGILE, "campaign", file.toString(), "--seeds", "5..5", "--shrink", "--json");
    JsonNode json = new ObjectMapper().readTree(cli.text()).get("shrunk");
    assertThat(json.get("replay").asText())
        .isEqualTo(
            "./starl run fragile --seed 5 --robots 2 --for 2100ms"
                + " --fault 'stuck(bot1,at=2s,for=187ms)' --set least=2");
    assertThat(json.get("robots").asInt()).isEqualTo(2);
    assertThat(paste("replay: " + json.get("replay").asText()).status()).isEqualTo(1);
  }

  @Test
  void anAppWithAFixedNumberOfRobotsShrinksWithAllOfThem() {
    Demos ofFour = new Demos(List.of(new OfFour()));
    Cli cli =
        Cli.run(
            ofFour,
            "campaign of-four --seeds 1..1 --shrink --fault stuck(bot1,at=2s,for=3s)".split(" "));
    assertThat(last(cli.err(), "shrunk in ")).matches(".* -> 4 robots, 1 fault, \\d+(ms|s)");
    assertThat(last(cli.err(), "replay: ")).doesNotContain("--robots");
  }

  @Test
  void aNumberOfRobotsThatChangesNothingIsTold() {
    Demos ofFour = new Demos(List.of(new OfFour(), new Fragile()));
    String picture = folder.resolve("a.png").toString();
    String told = "starl: --robots 6 changes nothing: of-four has 4";
    assertThat(Cli.run(ofFour, "run", "of-four", "--robots", "6", "--png", picture).err())
        .contains(told);
    assertThat(Cli.run(ofFour, "campaign of-four --seeds 1..2 --robots 6".split(" ")).err())
        .contains(told);
    for (String used : List.of("run of-four --robots 4", "run fragile --robots 6", "run of-four")) {
      assertThat(Cli.run(ofFour, (used + " --png " + picture).split(" ")).err())
          .noneMatch(line -> line.contains("changes nothing"));
    }
  }

  @Test
  void aGoodCampaignIsNotShrunk() {
    Cli cli = Cli.run(FRAGILE, "campaign fragile --seeds 1..2 --shrink".split(" "));
    assertThat(cli.status()).isZero();
    assertThat(cli.err()).noneMatch(line -> line.startsWith("shr"));
  }
}
