package org.starl.cli.campaign;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.check.ErrorRate;

/**
 * When a campaign ends before its last seed: with the smallest prefix of its seeds that decides it.
 * So its result depends neither on the threads' timing nor on how its seeds were sharded.
 *
 * @param stops whether the first bad run ends it
 * @param until the error rate to show; may be null
 */
public record Ending(boolean stops, @Nullable Until until) {

  static final Ending NEVER = new Ending(false, null);

  /**
   * An error rate to show.
   *
   * @param text as the user typed it
   * @param confidence above 0, below 1
   * @param below the rate, above 0, below 1
   * @param runs of the whole campaign
   */
  record Until(String text, double confidence, double below, long runs) {

    /**
     * The number of runs that show the rate if {@code bad} of them are bad; above {@link #runs} if
     * no number up to that one does.
     *
     * <p>The campaign looks at its result after each run. For each number of bad runs there is one
     * moment at which it may end, and each such moment gets a part of the permitted error: {@code 1
     * / ((bad + 1) (bad + 2))}, whose sum is 1. So the confidence holds although the campaign
     * chooses when to end.
     */
    long needed(long bad) {
      double part = (1 - confidence) / ((bad + 1.0) * (bad + 2.0));
      long low = bad;
      long high = runs + 1;
      while (high - low > 1) {
        long middle = (low + high) >>> 1;
        if (ErrorRate.below(bad, middle, 1 - part) < below) {
          high = middle;
        } else {
          low = middle;
        }
      }
      return high;
    }
  }

  private static final Pattern TEXT =
      Pattern.compile("(\\d{1,2}(?:\\.\\d{1,9})?) *% *< *(\\d*\\.?\\d+(?:[eE]-?\\d{1,2})?)");

  /**
   * @param untilText such as {@code 95% < 1e-5}; empty without
   * @throws BadInput if it is not of that form, or the seeds are too few for it
   */
  public static Ending of(boolean stops, String untilText, Seeds.Range range) {
    if (untilText.isEmpty()) {
      return new Ending(stops, null);
    }
    Matcher matcher = TEXT.matcher(untilText.strip());
    if (matcher.matches()) {
      double confidence = Double.parseDouble(matcher.group(1)) / 100;
      double below = Double.parseDouble(matcher.group(2));
      if (confidence > 0 && below > 0 && below < 1) {
        Until until = new Until(untilText, confidence, below, range.size());
        if (until.needed(0) > range.size()) {
          throw new BadInput(
              "--until: %s: expected more seeds than %s, which cannot show it even without a bad run"
                  .formatted(BadInput.quote(untilText), range));
        }
        return new Ending(stops, until);
      }
    }
    throw new BadInput(
        "--until: %s: expected a confidence and a rate, such as '95%% < 1e-5'"
            .formatted(BadInput.quote(untilText)));
  }

  String untilText() {
    return until == null ? "" : until.text;
  }

  /** Decides, after each run in seed order, whether it was the last one. */
  final class Watch {
    private long bad = -1;
    private long needed;

    /** Whether the runs of {@code tally} decide the campaign. */
    boolean decides(CampaignTally tally) {
      if (stops && tally.bad() > 0) {
        return true;
      }
      if (until == null) {
        return false;
      }
      if (tally.bad() != bad) {
        bad = tally.bad();
        needed = until.needed(bad);
      }
      return tally.runs() >= needed || needed > until.runs;
    }
  }

  /** Whether the runs fail to show the rate that they were to show. */
  boolean isMissed(CampaignTally tally) {
    return until != null && tally.runs() < until.needed(tally.bad());
  }

  /** A line about {@code --until}; none without. */
  List<String> lines(CampaignTally tally) {
    if (until == null) {
      return List.of();
    }
    long needed = until.needed(tally.bad());
    String what = "bad runs below %s at %s %%: ".formatted(ErrorRate.text(until.below), percent());
    if (!isMissed(tally)) {
      return List.of(what + "shown by %d of %d runs".formatted(tally.runs(), until.runs));
    }
    return List.of(
        what
            + "not shown: %d bad of %d runs, %s"
                .formatted(
                    tally.bad(),
                    tally.runs(),
                    needed > until.runs
                        ? "which more than %d runs would have to outweigh".formatted(until.runs)
                        : needed + " needed"));
  }

  private String percent() {
    return untilText().strip().split(" *%", 2)[0];
  }
}
