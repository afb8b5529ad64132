package org.starl.cli.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.starl.apps.Demo;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.Colour;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.cli.command.Shell;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.report.CiPage;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.ScenarioFile;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.Setting;
import org.starl.sim.TraceRecorder;
import org.starl.sim.check.RunArtifacts;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.kernel.CarrierKind;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl ci}. */
@Command(
    name = "ci",
    description =
        "Runs campaigns until a time is over, for a CI server: as many seeds of each app as fit."
            + " Leaves one folder: index.html, a report of each app, junit.xml, and the page, picture"
            + " and trace of each bad run as soon as it is found. Good seeds are kept there: while"
            + " no class changes, the next time only further ones run.",
    footer = {
      "",
      "Example: starl ci",
      "         starl ci my.yaml mutex --budget 10m --out target/ci"
    })
public final class CiCommand extends BaseCommand implements Callable<Integer> {

  /** A bad app may have as many bad runs as seeds. */
  private static final int MOST_SHOWN = 5;

  private static final int MOST_SEEDS = 100_000;

  /** Of an app's time, what its seeds get: steered runs, pictures and the page need the rest. */
  private static final double SEEDS_PART = 0.6;

  @Parameters(
      arity = "0..*",
      paramLabel = "APP|PRIMITIVE|FILE.yaml",
      description =
          "What to run (default: every app). An app or a primitive runs with the faults of its"
              + " envelope, as with --chaos; a scenario file as it says.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = "--budget",
      paramLabel = "TIME",
      defaultValue = "5m",
      description = "Real time for all of it, as 90s, 5m or 1h (default: ${DEFAULT-VALUE}).")
  private String budget = "";

  @Option(
      names = "--out",
      paramLabel = "FOLDER",
      defaultValue = "out/ci",
      description = "The folder (default: ${DEFAULT-VALUE}).")
  private String out = "";

  @Mixin private ThreadsOption threads = new ThreadsOption();

  /** What to run, with a name for its files. */
  private record Job(String name, RunRequest request) {}

  @Override
  public Integer call() throws InterruptedException, IOException {
    long budgetNs = budgetNs();
    List<Job> jobs = jobs();
    Path folder = Path.of(out);
    OutputFile.createFolder(folder.resolve("bad").toAbsolutePath());
    long endNs = System.nanoTime() + budgetNs;
    String classes = GoodSeeds.classes();
    JunitXml junit = new JunitXml();
    List<CiPage.Row> rows = new ArrayList<>();
    for (Job job : jobs) {
      long shareNs = (endNs - System.nanoTime()) / (jobs.size() - rows.size());
      rows.add(new Part(job, folder, junit).run(shareNs, classes));
      write(folder.resolve("junit.xml"), junit::write);
      byte[] page = CiPage.of(rows).getBytes(StandardCharsets.UTF_8);
      write(folder.resolve("index.html"), stream -> stream.write(page));
      if (stop().isStopped()) {
        break;
      }
    }
    boolean isGood = rows.size() == jobs.size() && rows.stream().allMatch(CiPage.Row::isGood);
    out().println("ci: " + (isGood ? "good" : "bad") + ": " + folder.resolve("index.html"));
    return isGood ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  /** A time with its unit; {@code m} means minutes. */
  private long budgetNs() {
    return OptionValues.read(
        "--budget",
        budget,
        text -> {
          long ns = Quantities.durationNs(text.matches("[0-9.]+m") ? text + "in" : text);
          if (ns == 0) {
            throw new BadInput(BadInput.quote(text) + ": expected a time above 0");
          }
          return ns;
        });
  }

  private List<Job> jobs() {
    List<Job> jobs = new ArrayList<>();
    List<String> wanted = names.isEmpty() ? apps() : names;
    for (String name : wanted) {
      boolean isFile = ScenarioFile.isScenario(name);
      ScenarioFile file = isFile ? ScenarioFile.read(name) : ScenarioFile.ofApp(name);
      RunRequest.Builder request = file.request(demos());
      if (!isFile) {
        request.set("", Setting.CHAOS.key(), "true");
      }
      Path path = Path.of(name).getFileName();
      String own = String.valueOf(path).replaceFirst("\\.ya?ml$", "");
      if (jobs.stream().anyMatch(job -> job.name.equals(own))) {
        throw new BadInput(name + ": " + own + " is there twice: expected other names");
      }
      Job job = new Job(own, request.build());
      job.request.plan(1).simulation().build();
      jobs.add(job);
    }
    return jobs;
  }

  private List<String> apps() {
    List<String> apps = new ArrayList<>();
    for (String name : demos().names()) {
      if (demos().byName(name).orElseThrow().kind() == Demo.Kind.APP) {
        apps.add(name);
      }
    }
    return apps;
  }

  /** The campaign of one job. */
  private final class Part {
    private final Job job;
    private final Path folder;
    private final JunitXml junit;
    private final List<String> problems = new ArrayList<>();
    private final List<String> pages = new ArrayList<>();
    private final CarrierKind carriers = Carriers.select(null, err());

    Part(Job job, Path folder, JunitXml junit) {
      this.job = job;
      this.folder = folder;
      this.junit = junit;
    }

    CiPage.Row run(long shareNs, String classes) throws InterruptedException, IOException {
      long untilNs = System.nanoTime() + (long) (SEEDS_PART * shareNs);
      Seeds.Range all = new Seeds.Range(1, MOST_SEEDS);
      SeedWork work = SeedWork.campaign(job.request, all, Ending.NEVER);
      GoodSeeds good = GoodSeeds.of(folder.resolve("good"), job.name, work, classes);
      GoodSeeds.removeOthers(folder.resolve("bad"), job.name, "-[0-9]+\\.[a-z]+", null);
      List<SeedRow> earlier = List.copyOf(good.rows().values());
      out().println(job.name + ": " + earlier.size() + " good seeds of an earlier run");
      CampaignTally tally = new CampaignTally(SteeredRuns.mayFollow(job.request));
      String report = job.name + ".html";
      String reportFile = folder.resolve(report).toString();
      try (ReportFile page = ReportFile.of(reportFile, all)) {
        Predicate<SeedRow> collected = CampaignCommand.collector(Ending.NEVER, tally, page);
        Consumer<SeedRow> take =
            row -> {
              if (row.outcome().isGood()) {
                good.add(row);
              }
              tell(row);
              if (collected.test(row)) {
                throw new IllegalStateException("ended before its time");
              }
            };
        int[] taken = new int[1];
        boolean isWhole = stop().completes(() -> taken[0] = runSeeds(work, earlier, take, untilNs));
        good.save();
        Seeds.Range done = new Seeds.Range(1, Math.max(1, tally.runs()));
        CampaignCommand.Output output =
            new CampaignCommand.Output(
                CiCommand.this,
                SeedWork.campaign(job.request, done, Ending.NEVER),
                carriers,
                threads.count(),
                false,
                false,
                reportFile,
                Shell.starl(job.request.campaign(done)),
                isWhole ? "" : "interrupted after " + tally.runs() + " runs");
        boolean isGood = CampaignCommand.print(output, tally, page) == ExitStatus.GOOD && isWhole;
        if (!isGood && problems.isEmpty()) {
          problems.add(
              isWhole ? "a steered run is bad, or a lemma was not checked" : "interrupted");
          junit.add(job.name, "the campaign", problems.getFirst());
        }
        long more = tally.runs() - tally.count(Verdict.GOOD) - problems.size();
        if (more > 0) {
          problems.add("and " + more + " more");
        }
        return new CiPage.Row(job.name, tally.runs(), taken[0], isGood, report, pages, problems);
      }
    }

    /**
     * Hands on all rows in order: those of an earlier command, and those of other seeds, which run.
     * Returns how many of the first it handed on.
     */
    private int runSeeds(SeedWork work, List<SeedRow> earlier, Consumer<SeedRow> take, long untilNs)
        throws InterruptedException {
      ShardWork.How how =
          new ShardWork.How(carriers, threads.count(), (finished, planned, bad) -> {});
      boolean[] isOver = new boolean[1];
      Predicate<SeedRow> isLast =
          row -> {
            take.accept(row);
            isOver[0] = System.nanoTime() - untilNs >= 0;
            return isOver[0];
          };
      int taken = 0;
      long next = 1;
      for (SeedRow row : earlier) {
        if (row.seed() > next) {
          work.runSeeds(new Seeds.Range(next, row.seed() - 1), how, true, isLast);
        }
        if (isOver[0]) {
          return taken;
        }
        take.accept(row);
        taken++;
        next = row.seed() + 1;
      }
      if (next <= MOST_SEEDS) {
        work.runSeeds(new Seeds.Range(next, MOST_SEEDS), how, true, isLast);
      }
      return taken;
    }

    /** Prints a bad run and writes its files at once. */
    private void tell(SeedRow row) {
      RunOutcome outcome = row.outcome();
      List<String> details = new ArrayList<>();
      if (!outcome.isGood()) {
        String line = new CampaignCommand.FirstBad(job.request, row).line();
        err().println(Colour.bad(job.name + ": " + line));
        if (problems.size() < MOST_SHOWN) {
          problems.add(line);
        }
        details.addAll(List.of(outcome.detail(), "replay: " + job.request.replay(row.seed())));
        if (pages.size() < MOST_SHOWN) {
          List<String> files = files(job, row, folder);
          details.addAll(files);
          files.stream().filter(name -> name.endsWith(".html")).forEach(pages::add);
        }
      }
      junit.add(job.name, row.seed(), outcome.verdict(), outcome.detail(), details);
    }
  }

  /** Runs a bad seed again for its trace, its picture and its page; their paths below the folder. */
  private static List<String> files(Job job, SeedRow row, Path folder) {
    Path trace = folder.resolve("bad").resolve(job.name + "-" + row.seed() + ".trace");
    long seed = row.seed();
    List<Path> files = new ArrayList<>(List.of(trace));
    try {
      try (OutputFile file = new OutputFile("--out", trace.toString());
          TraceRecorder recorder = new TraceRecorder(file.stream())) {
        job.request.plan(seed).simulation().observer(recorder).build().run();
      } catch (RuntimeException error) {
        if (!RunOutcome.failed(error).isLike(row.outcome())) {
          throw error;
        }
      }
      files.addAll(
          RunArtifacts.installed()
              .orElseThrow()
              .write(
                  trace,
                  job.request.vocabulary(seed),
                  job.request.plan(seed).simulation().build().plan(),
                  row.outcome().detail()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return files.stream().map(file -> folder.relativize(file).toString()).toList();
  }

  /** Writes a file. */
  @FunctionalInterface
  private interface Content {
    void write(OutputStream stream) throws IOException;
  }

  private static void write(Path file, Content content) throws IOException {
    try (OutputFile output = new OutputFile("--out", file.toString())) {
      content.write(output.stream());
    }
  }
}
