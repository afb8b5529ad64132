package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.hello.HelloDemo;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.StandsStill;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.TraceFile;
import org.starl.sim.TraceRecorder;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;

/** {@code starl replay} and {@code starl record} on traces, good ones and others. */
@Tag("long")
class ReplayTest {

  private static final Demos DEMOS = new Demos(List.of(new HelloDemo(), new Strict()));

  @TempDir private Path folder;
  private Path trace;

  /** Hello, with a specification that no robot drives. */
  private static final class Strict extends HelloWithATwist {
    Strict() {
      super("strict", "hello that must stand still");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation().monitor(StandsStill::new);
      return plan;
    }
  }

  private static Cli cli(String... words) {
    return Cli.run(DEMOS, words);
  }

  private Cli traced(String app, Path file) {
    String png = folder.resolve("a.png").toString();
    return cli("run", app, "--seed", "4", "--trace", file.toString(), "--png", png);
  }

  @BeforeEach
  void aTrace() {
    trace = folder.resolve("hello.trace");
    assertThat(traced("hello", trace).status()).isZero();
  }

  private Path changed(UnaryOperator<List<String>> change) throws IOException {
    Path other = folder.resolve("other.trace");
    List<String> lines = new ArrayList<>(Files.readAllLines(trace));
    Files.writeString(other, String.join("\n", change.apply(lines)) + "\n");
    return other;
  }

  private static void isRefused(Path file, String why) {
    for (String[] words :
        new String[][] {
          {"replay", file.toString(), "--headless"},
          {"record", file.toString(), "--out", file.resolveSibling("no.png").toString()}
        }) {
      Cli cli = cli(words);
      assertThat(cli.err()).hasSize(1).first().asString().contains(file.toString(), why);
      assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
      assertThat(file.resolveSibling("no.png")).doesNotExist();
    }
  }

  @Test
  void endsOfLinesAsOnWindowsMakeNoDifference() throws IOException {
    Path other = changed(lines -> lines.stream().map(line -> line + "\r").toList());
    Cli cli = cli("replay", other.toString(), "--headless");
    assertThat(cli.text()).contains("equal: ");
    assertThat(cli.status()).isZero();
  }

  @Test
  void theFirstDifferentLineIsReported() throws IOException {
    int[] number = new int[1];
    Path other =
        changed(lines -> {
          while (!lines.get(number[0]).contains("\"value\":\"MOVING\"")) {
            number[0]++;
          }
          return with(lines, number[0], "MOVING", "FAIL");
        });
    Cli cli = cli("replay", other.toString(), "--headless");
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.text())
        .contains("first difference at line " + (number[0] + 1), "  trace: {", "  replay: {");
    Cli json = cli("replay", other.toString(), "--headless", "--json");
    assertThat(json.text()).contains("\"equal\":false", "\"lines\":" + number[0]);
  }

  @Test
  void aFileThatIsNotATraceOfThisVersionIsRefusedInOneLine() throws IOException {
    isRefused(folder.resolve("none.trace"), "no such file");
    isRefused(Files.createDirectory(folder.resolve("dir.trace")), "is not a file");
    isRefused(Files.createFile(folder.resolve("empty.trace")), "expected the header");
    isRefused(
        Files.writeString(folder.resolve("poem.trace"), "roses are red\n"), "expected the header");
    isRefused(Files.write(folder.resolve("bytes.trace"), new byte[] {1, -1, 10}), "expected text");
    isRefused(changed(lines -> with(lines, 0, "\"format\":3,", "\"format\":9,")), "format 3");
    isRefused(
        changed(lines -> with(lines, 0, "\"starl\":\"0", "\"starl\":\"99")),
        "was written by StarL");
    isRefused(
        changed(lines -> with(lines, 0, ":\"hello\"", ":\"helo\"")), "no app is called 'helo'");
    isRefused(
        changed(lines -> with(lines, 0, "\"messageLoss\":", "\"messageLos\":")), "messageLos");
    isRefused(
        changed(
            lines -> with(lines, 0, "\"messageLoss\":", "\"waypointFile\":\"\",\"messageLoss\":")),
        ":1: no setting or parameter is called 'waypointFile'");
    isRefused(changed(lines -> with(lines, 0, "\"messageLoss\":\"", "\"messageLoss\":\"x")), "x0");
  }

  @Test
  void aBrokenLineIsRefusedWithItsNumber() throws IOException {
    isRefused(changed(lines -> lines.subList(0, 100)), "no line of kind end");
    String text = Files.readString(trace);
    isRefused(
        Files.writeString(folder.resolve("cut.trace"), text.substring(0, text.length() / 2)),
        "cut off inside it");
    isRefused(
        changed(lines -> {
          lines.add(20, lines.get(90));
          return lines;
        }),
        ":22: expected a time that is not before the one above");
    isRefused(
        changed(lines -> {
          lines.removeIf(line -> line.contains("\"joined\""));
          return lines;
        }),
        "expected a robot that has joined");
  }

  private static List<String> with(List<String> lines, int number, String old, String next) {
    assertThat(lines.get(number)).contains(old);
    lines.set(number, lines.get(number).replace(old, next));
    return lines;
  }

  @Test
  void aRunOfProcessesCannotBeRepeated() throws IOException {
    Path other =
        changed(lines -> {
          lines.add(
              1,
              "{\"kind\":\"fault\",\"timeNs\":0,\"robot\":\"world\",\"name\":\"begin\","
                  + "\"effect\":\"realtime\",\"detail\":\"realtime\"}");
          int last = lines.size() - 1;
          lines.set(last, lines.get(last).replaceFirst("\\d+}$", last - 1 + "}"));
          return lines;
        });
    Cli cli = cli("replay", other.toString(), "--headless");
    assertThat(cli.err()).singleElement().asString().contains("processes in real time");
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli("record", other.toString(), "--csv", "--out", out("a.csv")).status()).isZero();
  }

  private String out(String name) {
    return folder.resolve(name).toString();
  }

  @Test
  void aTraceGivesTheSameRecordingsAsItsRun() throws IOException {
    String file = trace.toString();
    for (String kind : List.of("--gif", "--mcap", "--png")) {
      Cli cli = cli("record", file, kind, "--out", out("x" + kind));
      assertThat(cli.err()).isEmpty();
      assertThat(folder.resolve("x" + kind)).isNotEmptyFile();
    }
    for (String table : List.of("positions", "messages", "variables")) {
      String ofTrace = out("trace-" + table);
      String ofRun = out("run-" + table);
      assertThat(cli("record", file, "--csv=" + table, "--out", ofTrace).status()).isZero();
      cli("record", "hello", "--seed", "4", "--csv=" + table, "--out", ofRun);
      assertThat(Files.readAllLines(Path.of(ofTrace))).hasSizeGreaterThanOrEqualTo(1);
      // A trace rounds places.
      if (!table.equals("positions")) {
        assertThat(Path.of(ofTrace)).hasSameTextualContentAs(Path.of(ofRun));
      }
    }
  }

  @Test
  void optionsThatChangeARunAreRefusedWithATrace() {
    String file = trace.toString();
    for (String[] option : new String[][] {{"--seed", "3"}, {"--loss", "0.3"}, {"--ideal"}}) {
      List<String> words = new ArrayList<>(List.of("record", file));
      words.addAll(List.of(option));
      Cli cli = cli(words.toArray(String[]::new));
      assertThat(cli.err())
          .singleElement()
          .asString()
          .contains(option[0] + " cannot be used with a trace");
      assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    }
    assertThat(cli("record", file, "--csv=pictures").err())
        .singleElement()
        .asString()
        .contains("expected positions, messages, variables or take");
  }

  @Test
  void aViolationIsFoundInTheTrace() {
    Path strict = folder.resolve("strict.trace");
    Cli run = traced("strict", strict);
    assertThat(run.status()).isEqualTo(ExitStatus.VIOLATED);
    Cli cli = cli("record", strict.toString(), "--gif", "--when", "violation", "--out", out("v"));
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(Path.of(out("v"))).isNotEmptyFile();
    assertThat(cli.err().stream().filter(line -> line.startsWith("VIOLATED")).toList())
        .isNotEmpty()
        .isEqualTo(run.out().stream().filter(line -> line.startsWith("VIOLATED")).toList());
    assertThat(cli.err()).contains("replay: ./starl replay " + strict + " --headless");
    assertThat(cli("replay", strict.toString(), "--headless").status()).isZero();
  }

  @Test
  void aRunWritesItsTables() throws IOException {
    Cli cli =
        cli(
            "run",
            "hello",
            "--csv-messages",
            out("m.csv"),
            "--csv-variables",
            out("v.csv"),
            "--png",
            out("a.png"));
    assertThat(cli.status()).isZero();
    assertThat(Files.readAllLines(Path.of(out("m.csv"))).get(0))
        .isEqualTo("time_s,event,from,to,channel,seq,bytes,text");
    assertThat(Files.readString(Path.of(out("v.csv"))))
        .startsWith("time_s,robot,source,name,value\n")
        .contains(",motion,motionflag,DONE\n");
    Cli bad = cli("run", "hello", "--csv-messages", folder.toString());
    assertThat(bad.err()).singleElement().asString().contains("--csv-messages");
    assertThat(bad.status()).isEqualTo(ExitStatus.BAD_INPUT);
  }

  /** Watches a run from its beginning, does something every 2 s of it, and stops it in the end. */
  private static void intervene(TraceFile with, Path into, List<String> faults) throws Exception {
    Plan plan = with.plan();
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    try (TraceRecorder recorder = new TraceRecorder(Files.newOutputStream(into));
        LiveRun live = new LiveRun(plan.simulation().observer(recorder), recording)) {
      live.start();
      long timeNs = 0;
      for (String fault : faults) {
        timeNs += 2_000_000_000L;
        live.runUntil(timeNs);
        while (recording.endNs() < timeNs) {
          Thread.onSpinWait();
        }
        live.fault(fault).get();
        live.point(with.header().robots().get(0), 100, -200).get();
      }
    }
  }

  @Test
  void interventionsAreRepeated() throws Exception {
    Path plain = folder.resolve("plain.trace");
    String png = folder.resolve("a.png").toString();
    String[] run = {"--seed", "7", "--set", "scenario=figure7", "--set", "debris=1"};
    List<String> words = new ArrayList<>(List.of("run", "intersection"));
    words.addAll(List.of(run));
    words.addAll(List.of("--trace", plain.toString(), "--png", png));
    assertThat(Cli.run(words.toArray(String[]::new)).status()).isZero();
    Path changed = folder.resolve("changed.trace");
    List<String> faults =
        List.of(
            "crash(bot1,restart=3s)",
            "loss(0.7,from=bot2,for=4s)",
            "skew(bot0,40ms)",
            "partition(bot0+bot1|bot2+bot3,for=2s)",
            "block(any,for=3s)",
            "flood(bot3,5ms,for=1s)");
    intervene(TraceFile.open(plain.toString(), Apps.ALL), changed, faults);
    assertThat(changed).content().contains("\"kind\":\"intervention\"", "\"name\":\"stop\"");
    Cli replayed = Cli.run("replay", changed.toString(), "--headless");
    assertThat(replayed.out().get(replayed.out().size() - 1)).startsWith("equal: ");
    assertThat(replayed.status()).isZero();
  }
}
