package org.starl.cli.request;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.command.Apps;
import org.starl.sim.Setting;
import picocli.CommandLine;

public final class RunRequestTest {

  @TempDir private Path folder;

  public static RunRequest request(List<String> words) {
    RunOptions.OfApp options = new RunOptions.OfApp();
    CommandLine line = new CommandLine(options);
    line.addMixin("seed", new SeedOption());
    line.parseArgs(words.toArray(String[]::new));
    return options.request(Apps.ALL);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "hello",
        "hello --robots 3 --for 2min --loss 0.5",
        "intersection --loss 0.1 --delay uniform(10ms,50ms) --gps-noise 2cm --ideal --chaos",
        "intersection --fault crash(bot1,at=2s) --fault loss(0.9,from=bot1) --set debris=0",
        "search --set chaos=logical --set idealMotion=no --set headingNoise=0.1deg --set rooms=3",
        "mutex --set drawTrails=true --set trailLength=7 --set busy=3s --set chaos=off",
        "race --set faults=slow(bot0,0.5);partition(bot0|bot1,at=1s,for=2s) --set robots=2"
      })
  void itsCommandLineMakesTheSameRequest(String words) {
    RunRequest request = request(List.of(words.split(" ")));
    RunRequest again = request(request.words(7));
    assertThat(again).isEqualTo(request);
    assertThat(again.settings().given()).isEqualTo(request.settings().given());
    assertThat(again.words(7)).isEqualTo(request.words(7));
  }

  /** How many of the first hundred seeds seal their datagrams. */
  private static long sealed(String words) {
    RunRequest request = request(List.of(words.split(" ")));
    return LongStream.rangeClosed(1, 100)
        .filter(seed -> request.plan(seed).simulation().settings().get(Setting.SEALED))
        .count();
  }

  @Test
  void chaosSealsTheDatagramsOfAQuarterOfTheSeedsUnlessTheUserSaysSo() {
    assertThat(sealed("agreement --chaos")).isBetween(15L, 35L);
    assertThat(sealed("race --set chaos=network")).isBetween(15L, 35L);
    assertThat(sealed("agreement --chaos --set sealed=false")).isZero();
    assertThat(sealed("agreement --chaos --set sealed=true")).isEqualTo(100);
    assertThat(sealed("agreement")).isZero();
  }

  @Test
  void aScenarioFileAndOptionsMakeTheSameRequest() throws IOException {
    Path file = folder.resolve("my.yaml");
    Files.writeString(
        file, "app: race\nmessageLoss: 0.3\nchaos: yes\nfaults: [crash(bot1,at=2s)]\n");
    RunRequest ofFile = request(List.of(file.toString(), "--fault", "crash(bot2,at=3s)"));
    assertThat(ofFile)
        .isEqualTo(
            request(
                List.of(
                    "race --loss 0.3 --chaos --fault crash(bot1,at=2s) --fault crash(bot2,at=3s)"
                        .split(" "))));
    assertThat(ofFile.replay(7))
        .isEqualTo(
            "./starl run race --seed 7 --loss 0.3 --fault 'crash(bot1,at=2s)' --fault"
                + " 'crash(bot2,at=3s)' --chaos");
  }

  static Stream<List<String>> requestsOfDefaults() {
    return Apps.ALL.all().stream()
        .flatMap(demo -> {
          Stream<String> keys =
              demo.parameters().stream().map(p -> p.key() + "=" + p.defaultValue());
          return Stream.concat(keys, Stream.of("robots=4", "chaosFor=20s", "duration=1200s"))
              .map(value -> List.of(demo.name(), "--chaos", "--set", value));
        });
  }

  @ParameterizedTest
  @MethodSource("requestsOfDefaults")
  void chaosKeepsAGivenValueThatIsTheDefault(List<String> words) {
    String[] given = words.getLast().split("=", 2);
    RunRequest request = request(words);
    for (long seed = 1; seed <= 6; seed++) {
      var header = request.plan(seed).simulation().build().plan().header();
      assertThat(header.settings()).as("seed %d", seed).containsEntry(given[0], given[1]);
    }
  }

  @Test
  void chaosKeepsAGivenScenario() {
    RunRequest drawn = request(List.of("intersection", "--chaos", "--set", "scenario=drawn"));
    for (long seed = 1; seed <= 6; seed++) {
      assertThat(drawn.varied(seed).parameters())
          .containsEntry("scenario", "drawn")
          .doesNotContainKey("arrivals"); // they would change it
    }
  }

  @Test
  void settingsOfTheWindowReachTheTracesHeader() {
    RunRequest request = request(List.of("hello", "--set", "drawTrails=yes"));
    var header = request.plan(1).simulation().build().plan().header();
    assertThat(header.settings())
        .containsEntry("drawTrails", "true")
        .containsEntry("messageLoss", "0")
        .doesNotContainKeys("trailLength", Setting.ROBOTS.key());
  }
}
