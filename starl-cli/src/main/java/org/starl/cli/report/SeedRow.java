package org.starl.cli.report;

import java.util.Collections;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.check.RunOutcome;

/**
 * What a campaign or a sweep keeps of one run: all that its output and its report need. Equal runs
 * have equal rows, and {@link #of} of {@link #line} is the same row.
 *
 * @param key a digest of version, app and settings
 * @param point of the sweep, from 0; 0 in a campaign
 * @param kinds of the faults that began in the run
 * @param facts null if an exception ended the run, as is {@code coverage}
 */
public record SeedRow(
    String key,
    int point,
    long seed,
    RunOutcome outcome,
    SortedSet<String> kinds,
    @Nullable RunFacts facts,
    @Nullable Coverage coverage) {

  public SeedRow {
    Objects.requireNonNull(key);
    Objects.requireNonNull(outcome);
    kinds = Collections.unmodifiableSortedSet(new TreeSet<>(kinds));
  }

  /** The row as JSON on one line. */
  public String line() {
    return RowJson.line(this);
  }

  /**
   * The row of a line.
   *
   * @param where the place of the line, for errors: {@code part-3:17: }
   * @throws BadInput if it is none
   */
  public static SeedRow of(String where, String line) {
    return RowJson.read(where, line, SeedRow.class);
  }
}
