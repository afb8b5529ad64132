package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.Collections;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.check.RunOutcome;

/**
 * What a campaign keeps of one run: all that its output and its report need. Equal runs have equal
 * rows, and {@link #of} of {@link #line} is the same row.
 *
 * @param key of the campaign: its version, app and settings
 * @param kinds of the faults that began in the run
 * @param facts null if an exception ended the run, as is {@code coverage}
 */
public record SeedRow(
    String key,
    long seed,
    RunOutcome outcome,
    SortedSet<String> kinds,
    @Nullable RunFacts facts,
    @Nullable Coverage coverage) {

  /** Reads and writes records by their components. */
  private static final ObjectMapper MAPPER =
      JsonMapper.builder()
          .visibility(PropertyAccessor.ALL, Visibility.NONE)
          .visibility(PropertyAccessor.FIELD, Visibility.ANY)
          .visibility(PropertyAccessor.CREATOR, Visibility.ANY)
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  public SeedRow {
    Objects.requireNonNull(key);
    Objects.requireNonNull(outcome);
    kinds = Collections.unmodifiableSortedSet(new TreeSet<>(kinds));
  }

  /** The row as JSON on one line. */
  public String line() {
    try {
      return MAPPER.writeValueAsString(this);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("row of seed " + seed, e);
    }
  }

  /**
   * The row of a line.
   *
   * @param where the place of the line, for errors: {@code part-3:17: }
   * @throws BadInput if it is none
   */
  public static SeedRow of(String where, String line) {
    try {
      return MAPPER.readValue(line, SeedRow.class);
    } catch (JsonProcessingException e) {
      throw new BadInput(where + BadInput.quote(line) + ": expected a row of a campaign");
    }
  }
}
