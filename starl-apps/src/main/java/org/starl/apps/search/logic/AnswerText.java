package org.starl.apps.search.logic;

import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.id.RobotId;

/** Answers as text: robots send them in this form, which people read too. */
final class AnswerText {

  static final String NOTHING = "nothing there";

  /** Followed by the rooms, with a space between two. */
  static final String GAVE_UP = "gave up, could not search ";

  // A thing may have any name, so the place is the last one in the text.
  private static final Pattern FOUND =
      Pattern.compile("found (.*) at (-?[0-9]{1,18}),(-?[0-9]{1,18}) by (.*)", Pattern.DOTALL);

  private AnswerText() {}

  /**
   * The answer whose {@code toString} is {@code text}.
   *
   * @throws IllegalArgumentException if there is none
   */
  static Answer parse(String text) {
    if (text.equals(NOTHING)) {
      return Answer.NOTHING;
    }
    if (text.startsWith(GAVE_UP)) {
      String rooms = text.substring(GAVE_UP.length());
      return new Answer.GaveUp(Arrays.asList(rooms.split(" ", -1)));
    }
    Matcher found = FOUND.matcher(text);
    if (found.matches()) {
      long xMm = Long.parseLong(found.group(2));
      long yMm = Long.parseLong(found.group(3));
      Answer answer = new Answer.Found(found.group(1), xMm, yMm, new RobotId(found.group(4)));
      if (answer.toString().equals(text)) { // not if it has zeros in front of a number
        return answer;
      }
    }
    throw new IllegalArgumentException("answer '" + text + "'");
  }
}
