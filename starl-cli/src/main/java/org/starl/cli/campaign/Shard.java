package org.starl.cli.campaign;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;

/**
 * One of {@code count} parts of a work. Of numbered runs, such as a campaign's seeds: neighbouring
 * numbers, and as many as in any other part, or one more.
 *
 * @param number from 1 to {@code count}
 */
record Shard(int number, int count) {

  private static final Pattern TEXT = Pattern.compile("(\\d{1,9})/(\\d{1,9})");

  /**
   * @throws BadInput unless it is {@code K/N}, with K from 1 to N and N at most the number of runs
   */
  static Shard of(String where, String text, ShardWork<?> work) {
    Matcher matcher = TEXT.matcher(text.strip());
    if (matcher.matches()) {
      int number = Integer.parseInt(matcher.group(1));
      int count = Integer.parseInt(matcher.group(2));
      if (1 <= number && number <= count && count <= work.numbers().size()) {
        return new Shard(number, count);
      }
    }
    throw new BadInput(
        "%s: %s: expected K/N, with 1 <= K <= N and at most a shard for each of %d %ss"
            .formatted(where, BadInput.quote(text), work.numbers().size(), work.unit()));
  }

  Seeds.Range seeds(Seeds.Range all) {
    long first = all.first() + (number - 1) * all.size() / count;
    long next = all.first() + number * all.size() / count;
    return new Seeds.Range(first, next - 1);
  }

  @Override
  public String toString() {
    return number + "/" + count;
  }
}
