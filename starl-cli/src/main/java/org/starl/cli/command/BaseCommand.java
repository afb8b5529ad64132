package org.starl.cli.command;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The context of a command: its writers, and the apps that the command line knows. */
public abstract class BaseCommand {

  private static final List<String> FLAGS_OF_OUTPUT = List.of("--json", "--resume", "--shrink");
  private static final List<String> OPTIONS_OF_OUTPUT =
      List.of(
          "--chart",
          "--csv",
          "--on",
          "--out",
          "--parquet",
          "--print-job",
          "--report",
          "--shard",
          "--shards",
          "--threads");

  /** The main class, for another Java process; its package imports this one. */
  public static final String MAIN = "org.starl.cli.Main";

  /** The command that all others are below. */
  public interface Root {

    /** The apps that this command line knows. */
    Demos demos();

    /** What a signal does. */
    UntilStopped stop();
  }

  @Spec private @Nullable CommandSpec spec;

  public final CommandSpec spec() {
    return Objects.requireNonNull(spec);
  }

  public final PrintWriter out() {
    return spec().commandLine().getOut();
  }

  public final PrintWriter err() {
    return spec().commandLine().getErr();
  }

  public final Demos demos() {
    return root().demos();
  }

  /** What a signal does. */
  public final UntilStopped stop() {
    return root().stop();
  }

  /** Shows progress of this command, which a signal tells if the command cannot end early. */
  public final ProgressLine progress(String units) {
    ProgressLine line = new ProgressLine(err(), units);
    stop().progress(line::stopped);
    return line;
  }

  private Root root() {
    return (Root) spec().root().userObject();
  }

  /**
   * The words of the command line as the user typed it, after the launcher, without the options that
   * do not change the result.
   */
  public final List<String> words() {
    List<String> words = new ArrayList<>();
    boolean isValue = false;
    for (String word : originalWords()) {
      String option = word.split("=", 2)[0];
      if (!isValue && !FLAGS_OF_OUTPUT.contains(word) && !OPTIONS_OF_OUTPUT.contains(option)) {
        words.add(word);
      }
      isValue = OPTIONS_OF_OUTPUT.contains(word);
    }
    return words;
  }

  /** All words of the command line as the user typed it, after the launcher. */
  public final List<String> originalWords() {
    return spec().root().commandLine().getParseResult().originalArgs();
  }

  /** The command line as typed, with another value of an option that it has. */
  public final String typedWith(String option, String value) {
    List<String> words = new ArrayList<>(originalWords());
    for (int i = 0; i < words.size(); i++) {
      if (words.get(i).equals(option)) {
        words.set(i + 1, value);
      } else if (words.get(i).startsWith(option + "=")) {
        words.set(i, option + "=" + value);
      }
    }
    return Shell.starl(words);
  }

  /** The command line of {@link #words}. */
  public final String typed() {
    return Shell.starl(words());
  }
}
