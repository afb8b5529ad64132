package org.starl.cli.command;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option for the number of threads that run simulations. */
public final class ThreadsOption {

  private static final int MAX_THREADS = 1024;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Number of threads (default: one per core).")
  private @Nullable String threads;

  public int count() {
    return threads == null
        ? Runtime.getRuntime().availableProcessors()
        : OptionValues.whole("--threads", threads, 1, MAX_THREADS);
  }
}
