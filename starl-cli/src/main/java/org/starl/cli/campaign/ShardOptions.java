package org.starl.cli.campaign;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.Shell;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The options of a command that writes a row for each run, for {@code starl merge}. */
final class ShardOptions {

  /** The commands with these options. */
  static final List<String> COMMANDS = List.of("campaign", "sweep", "explore");

  @Option(
      names = "--shard",
      paramLabel = "K/N",
      description = "Run only part K of N; needs --out. 'starl merge' joins the parts.")
  private @Nullable String shard;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Write a row for each run to FILE, for 'starl merge', instead of the result.")
  private @Nullable String out;

  @Option(
      names = "--resume",
      description = "Continue FILE of --out after its last row; begin it if there is none.")
  private boolean resume;

  @Option(
      names = "--print-job",
      paramLabel = "SCHEDULER",
      description =
          "Run nothing, but print a job of --shards parts: kubernetes (an Indexed Job) or slurm (an"
              + " array script).")
  private JobScript.@Nullable Scheduler scheduler;

  @Option(
      names = "--shards",
      paramLabel = "N",
      defaultValue = "64",
      description = "Parts of the job of --print-job (default: ${DEFAULT-VALUE}).")
  private String shards = "64";

  /** Prints a job and returns true, if {@code --print-job} is given. */
  boolean printJob(BaseCommand command, ShardWork<?> work) {
    if (scheduler == null) {
      return false;
    }
    int most = (int) work.numbers().size();
    int count = OptionValues.whole("--shards", shards, 1, most);
    command.out().print(JobScript.of(scheduler, work.app(), command.words(), count));
    return true;
  }

  /** Whether several processes are to share the work. */
  boolean isShared() {
    return out != null || scheduler != null;
  }

  /**
   * Whether the command writes rows.
   *
   * @param others names of the given options that need the result
   */
  boolean isOn(String... others) {
    if (out == null && (shard != null || resume)) {
      throw new BadInput((shard != null ? "--shard" : "--resume") + " needs --out FILE");
    }
    if (out != null && others.length > 0) {
      throw new BadInput(
          others[0]
              + " cannot be used with --out"
              + (others[0].equals("--on")
                  ? ": an engine makes its own shards"
                  : "; expected it at 'merge'"));
    }
    return out != null;
  }

  /**
   * Runs the shard and writes its file.
   *
   * @return the exit status. A shard is good if its file is complete; its runs may be bad: a scheduler
   *     would repeat it, and the merge tells
   */
  <R> int run(BaseCommand command, ShardWork<R> work, int workers, JsonOption json)
      throws InterruptedException, IOException {
    String name = out == null ? "" : out;
    Shard part = shard == null ? new Shard(1, 1) : Shard.of("--shard", shard, work);
    ShardHeader header = ShardHeader.of(work, part, command.typed());
    ShardWork.Part<R> runs = work.part(part);
    Counts counts = new Counts();
    Predicate<R> kept =
        row -> {
          counts.add(work.isGood(row));
          return runs.keep(row);
        };
    String units = work.unit().equals("schedule") ? "schedules" : "runs";
    ProgressLine progress = command.progress(units);
    boolean isWhole;
    try (ShardFile file =
        resume ? ShardFile.resume(name, header, work, kept) : ShardFile.create(name, header)) {
      ShardWork.How how =
          new ShardWork.How(Carriers.select(null, command.err()), workers, progress);
      isWhole =
          command
              .stop()
              .completes(() ->
                  runs.run(
                      how,
                      row -> {
                        try {
                          file.append(work.line(row));
                        } catch (IOException e) {
                          throw new UncheckedIOException(e);
                        }
                        counts.add(work.isGood(row));
                        return false;
                      }));
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    progress.end();
    print(command, work, part, counts, name, json);
    if (!isWhole) {
      long planned = work.isNumbered() ? part.seeds(work.numbers()).size() : work.numbers().size();
      command.err().println(interrupted(command, counts.rows, planned, units));
    }
    return shard == null && counts.bad > 0 ? ExitStatus.VIOLATED : ExitStatus.GOOD;
  }

  /**
   * A line after a signal: how much was done, and how to go on. Only rows that are kept in a file
   * can be gone on from.
   */
  String interrupted(BaseCommand command, long done, long planned, String units) {
    List<String> words = new ArrayList<>(command.originalWords());
    if (out != null && !resume) {
      words.add("--resume");
    }
    return "interrupted after %d of %d %s; %s"
        .formatted(
            done,
            planned,
            units,
            out == null
                ? "to be able to go on, begin with --out FILE, which --resume continues"
                : "to go on: " + Shell.starl(words));
  }

  private static void print(
      BaseCommand command,
      ShardWork<?> work,
      Shard part,
      Counts counts,
      String name,
      JsonOption json) {
    String units = work.unit() + "s";
    Map<String, Object> object = Json.object("app", work.app(), "shard", part.toString());
    String numbers = "";
    if (work.isNumbered()) {
      object.put(units, part.seeds(work.numbers()).toString());
      numbers = ", " + units + " " + part.seeds(work.numbers());
    }
    object.putAll(Json.object("rows", counts.rows, "bad", counts.bad, "file", name));
    String line =
        "%s, shard %s%s: %d rows in %s, %d bad"
            .formatted(work.app(), part, numbers, counts.rows, name, counts.bad);
    json.print(command.out(), object, List.of(line));
  }

  private static final class Counts {
    private long rows;
    private long bad;

    void add(boolean isGood) {
      rows++;
      bad += isGood ? 0 : 1;
    }
  }
}
