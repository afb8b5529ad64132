package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Demos;
import org.starl.apps.Measures;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.StandsStill;
import org.starl.cli.command.ExitStatus;

/** {@code starl campaign --shard}, {@code --resume}, {@code --until}, and {@code starl merge}. */
@Tag("long")
class ShardTest {

  private static final Demos MIXED = new Demos(List.of(new Mixed()));

  @TempDir private Path folder;

  /** Hello with runs that fail in each way, and a measure that a test changes. */
  private static final class Mixed extends HelloWithATwist {

    /** Stands for a state that survives a run, such as a hash order. */
    private static int leaked;

    Mixed() {
      super("mixed", "Hello that fails in each way.");
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(
          new Parameter("every", "7", "which seeds fail"),
          new Parameter("leaks", "no", "what runs depend on: earlier ones, or hash"));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      long every = Long.parseLong(request.parameter("every"));
      switch ((int) (request.seed() % (3 * every))) {
        case 0 -> plan.simulation().monitor(StandsStill::new);
        case 1 -> plan.simulation().endNs(1_000_000_000);
        case 2 ->
            plan.simulation()
                .director(control ->
                    control.at(
                        1_000_000_000,
                        () -> {
                          throw new IllegalStateException("of the test");
                        }));
        default -> {
          // goes well
        }
      }
      if (request.parameter("leaks").equals("no")) {
        return plan;
      }
      leaked++;
      int measure = request.parameter("leaks").equals("hash") ? orderByHash() : leaked;
      return new Plan(
          plan.simulation(), new Leaking(plan.story(), measure), plan.layer(), plan.obstacles());
    }

    /** A number for the order in which a set in the order of identity hashes has some objects. */
    private static int orderByHash() {
      List<Object> objects = new ArrayList<>();
      for (int i = 0; i < 100; i++) {
        objects.add(new Object());
      }
      int order = 0;
      for (Object each : new HashSet<>(objects)) {
        order = 31 * order + objects.indexOf(each);
      }
      return order & Integer.MAX_VALUE;
    }
  }

  /** The story of a run, with one figure that does not come from its seed. */
  private record Leaking(Story story, int leaked) implements Story {
    @Override
    public List<String> lines() {
      return story.lines();
    }

    @Override
    public Measures measures() {
      Measures measures = story.measures();
      return new Measures(
          leaked, measures.completed(), measures.waitsNs(), measures.figures(), measures.counts());
    }

    @Override
    public List<Sample> samples() {
      return story.samples();
    }
  }

  private static Cli run(String line, Object... files) {
    return Cli.line(MIXED, line, files);
  }

  private Path part(String campaign, int number, int count) {
    return Cli.shard(MIXED, folder, campaign, number, count);
  }

  private List<Path> parts(String campaign, int count) {
    return Cli.shards(MIXED, folder, campaign, count);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--seeds 1..200",
        "--seeds 3..62 --loss 0.3 --chaos --json",
        "--seeds 3..202 --set every=40 --stop",
        "--seeds 1..200 --set every=1000 --until 95%<3e-2"
      })
  void shardsMergedInAnyOrderPrintWhatOneProcessPrints(String options) {
    String campaign = "campaign mixed " + options;
    Cli whole = run(campaign + " --threads 3");
    List<Path> files = parts(campaign, 7);
    files.addAll(parts(campaign, 2));
    for (int order = 0; order < 3; order++) {
      Collections.shuffle(files, new Random(order));
      run("merge" + (options.endsWith("--json") ? " --json" : ""), files.toArray())
          .assertSame(whole);
    }
  }

  @Test
  void shardsMergedMakeThePageOfOneProcess() throws IOException {
    Path page = folder.resolve("page.html");
    String campaign = "campaign mixed --seeds 3..40 --loss 0.1 --chaos";
    Cli whole = run(campaign + " --report", page);
    String expected = Files.readString(page);
    Files.delete(page);
    List<Object> words = new ArrayList<>(parts(campaign, 5));
    Collections.reverse(words);
    words.add("--report");
    words.add(page);
    run("merge", words.toArray()).assertSame(whole);
    assertThat(Files.readString(page)).isEqualTo(expected);
  }

  @Test
  void coverageOfShardsIsThatOfOneProcess() throws IOException {
    Path page = folder.resolve("page.html");
    String campaign = "campaign mutex --seeds 1..5 --robots 3 --set rounds=4";
    Cli whole = Cli.run((campaign + " --report " + page).split(" "));
    String expected = Files.readString(page);
    assertThat(whole.text()).contains("deliveries of mutex: ").contains("coverage of Mutex_decls");
    List<String> merge = new ArrayList<>(List.of("merge"));
    for (String part : List.of("2/2", "1/2")) {
      String file = folder.resolve(part.replace('/', '-')).toString();
      Cli cli = Cli.run((campaign + " --shard " + part + " --out " + file).split(" "));
      assertThat(cli.status()).as("%s", cli).isZero();
      merge.add(file);
    }
    merge.addAll(List.of("--report", page.toString()));
    Cli.run(merge.toArray(String[]::new)).assertSame(whole);
    assertThat(Files.readString(page)).isEqualTo(expected).contains("Deliveries by phase");
  }

  @Test
  void anInterruptedShardIsResumedToTheSameBytes() throws IOException {
    String campaign = "campaign mixed --seeds 1..12";
    Cli.assertResumes(MIXED, campaign, part(campaign, 1, 1));
  }

  @Test
  void aThreadThatASignalHasInterruptedStillWritesItsRow() throws IOException {
    Path rows = folder.resolve("rows");
    ShardHeader header = new ShardHeader(Map.of(), "1/1", "campaign hello");
    try (ShardFile file = ShardFile.create(rows.toString(), header)) {
      Thread.currentThread().interrupt();
      file.append("a row");
    } finally {
      assertThat(Thread.interrupted()).isTrue();
    }
    assertThat(rows).content().isEqualTo(header.line() + "\na row\n");
  }

  @Test
  void aResumedShardRunsOnlyTheMissingSeeds() throws IOException {
    String campaign = "campaign mixed --seeds 1..6 --set leaks=yes";
    Path file = part(campaign, 1, 1);
    List<String> before = Files.readAllLines(file);
    Files.write(file, before.subList(0, 4));
    assertThat(run(campaign + " --resume --out", file).status()).isEqualTo(ExitStatus.VIOLATED);
    List<String> after = Files.readAllLines(file);
    assertThat(after).hasSize(7);
    assertThat(after.subList(0, 4)).isEqualTo(before.subList(0, 4));
    // A run of seed 4 again leaks another number.
    assertThat(after.get(4)).isNotEqualTo(before.get(4));
  }

  @ParameterizedTest
  @ValueSource(strings = {"yes", "hash"})
  void aRunThatDependsOnMoreThanItsSeedIsFoundByTheMerge(String leaks) {
    String campaign = "campaign mixed --seeds 4..6 --threads 1 --set leaks=" + leaks;
    Path one = part(campaign, 1, 1);
    Path other = folder.resolve("again");
    assertThat(run(campaign + " --out", other).status()).isLessThan(ExitStatus.BAD_INPUT);
    Cli cli = run("merge", one, other);
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.out()).isEmpty();
    assertThat(cli.err()).hasSize(3);
    assertThat(cli.err().getFirst())
        .startsWith(
            "starl: determinism bug: seed 4 has different rows in "
                + one
                + " and "
                + other
                + ": facts.measures.came: '");
  }

  @Test
  void filesThatDoNotMakeOneCampaignAreRefused() throws IOException {
    String campaign = "campaign mixed --seeds 1..9";
    Path one = part(campaign, 1, 3);
    Path two = part(campaign, 2, 3);
    Path three = part(campaign, 3, 3);
    run("merge", one, three).assertRefused("seeds 4..6 of 1..9 are missing", "all shards");
    run("merge", one, two).assertRefused("seeds 7..9 of 1..9 are missing");
    String whole = Files.readString(three);
    Files.writeString(three, whole.substring(0, whole.length() - 1), StandardCharsets.UTF_8);
    run("merge", one, two, three)
        .assertRefused("seed 9 of 1..9 is missing", "--resume", "part-3-of-3");
    Path seeds = part("campaign mixed --seeds 1..8", 1, 8);
    run("merge", one, seeds).assertRefused("part-1-of-8:1: seeds: 1..8: expected 1..9");
    Path loss = part(campaign + " --loss 0.1", 1, 9);
    run("merge", one, loss).assertRefused("part-1-of-9:1: settings: ", "messageLoss");
    Path old = folder.resolve("old");
    Files.writeString(old, whole.replaceFirst("\"starl\":\"[^\"]*\"", "\"starl\":\"0.0.1\""));
    run("merge", old).assertRefused("old:1: was written by StarL '0.0.1'; expected");
    Path text = Files.writeString(folder.resolve("text"), "what\n");
    run("merge", text).assertRefused("text:1: 'what': expected a file of 'starl campaign --out'");
    run("merge", folder.resolve("none")).assertRefused("none: no such file");
    String row = whole.lines().skip(1).findFirst().orElseThrow();
    Path damaged = folder.resolve("damaged");
    Files.writeString(damaged, whole.replace(row, row.substring(5)));
    run("merge", one, two, damaged).assertRefused("damaged:2: ", "expected a row of a shard");
    Files.writeString(damaged, whole.replace(row, row + "\n" + row));
    run("merge", one, two, damaged)
        .assertRefused("damaged:3: seed: 7: expected those of shard 3/3 in order");
    Files.writeString(damaged, whole.replace("{\"key\":\"", "{\"key\":\"0"));
    run("merge", one, two, damaged).assertRefused("damaged:2: key: ");
  }

  @Test
  void aFileThatIsNotTheShardsOwnIsNotResumed() throws IOException {
    String campaign = "campaign mixed --seeds 1..9";
    Path one = part(campaign, 1, 3);
    byte[] before = Files.readAllBytes(one);
    run(campaign + " --shard 1/3 --out", one).assertRefused("exists already", "--resume");
    run(campaign + " --shard 2/3 --resume --out", one).assertRefused("shard: 1/3: expected 2/3");
    run(campaign + " --loss 0.5 --shard 1/3 --resume --out", one).assertRefused(":1: settings: ");
    assertThat(Files.readAllBytes(one)).isEqualTo(before);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--shard 0/3 --out x | --shard: '0/3': expected K/N",
        "--shard 4/3 --out x | --shard: '4/3': expected K/N",
        "--shard 1/11 --out x | each of 10 seeds",
        "--shard 1/2 | --shard needs --out",
        "--resume | --resume needs --out",
        "--out x --report y | --report cannot be used with --out",
        "--until 95 | --until: '95': expected a confidence and a rate",
        "--until 95%<1.5 | expected a confidence",
        "--until 95%<1e-3 | expected more seeds than 1..10"
      })
  void badOptionsAreRefused(String line) {
    String[] parts = line.split(" \\| ");
    run("campaign mixed --seeds 1..10 " + parts[0]).assertRefused(parts[1]);
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void sparkIsNotOnTheClassPathOfTheCommandLine() {
    Cli cli = run("campaign mixed --seeds 1..10 --on spark");
    assertThat(cli.status()).isEqualTo(ExitStatus.MISSING_DEPENDENCY);
    assertThat(cli.err()).hasSize(1);
    assertThat(cli.err().getFirst())
        .startsWith(
            "starl: --on spark: Spark is not on the class path; expected './starl campaign");
  }

  @Test
  void aRateIsShownByTheFewestRuns() {
    // 1 - 0.025^(1/n) < 0.03 from n = 122 on.
    Cli good = run("campaign mixed --seeds 30..400 --set every=1000 --until 95%<3e-2");
    assertThat(good.status()).isZero();
    assertThat(good.out()).contains("bad runs below 3 % at 95 %: shown by 122 of 371 runs");
    assertThat(good.text()).containsPattern("runs +122\n");
  }

  @Test
  void aRateThatCanNoLongerBeShownEndsTheCampaign() {
    Cli bad = run("campaign mixed --seeds 3..140 --set every=7 --until 95%<3e-2");
    assertThat(bad.status()).isEqualTo(ExitStatus.VIOLATED);
    // The first bad run, seed 21, leaves too few others.
    assertThat(bad.text()).containsPattern("runs +19\n");
    assertThat(bad.text()).contains("not shown: 1 bad of 19 runs");
  }
}
