package org.starl.lang.read;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The parser's messages in the form of all others: what was found; what was expected. */
final class SyntaxMessage {

  private static final Pattern UNEXPECTED =
      Pattern.compile("(?:mismatched|extraneous) input (.*) expecting (.*)");
  private static final Pattern MISSING = Pattern.compile("missing (.*) at (.*)");
  private static final Pattern NO_WAY = Pattern.compile("no viable alternative at input (.*)");
  private static final Pattern NO_WORD = Pattern.compile("token recognition error at: (.*)");

  /** May follow every expression: to name them says nothing. */
  private static final Set<String> OPERATORS =
      Set.of(
          "'='",
          "'!='",
          "'<'",
          "'<='",
          "'>'",
          "'>='",
          "'=>'",
          "'<=>'",
          "'+'",
          "'-'",
          "'*'",
          "'/'",
          "'('",
          "'.'",
          "'union'",
          "'minus'",
          "'intersect'",
          "'in'",
          "'subset'",
          "'disjoint'",
          "'is'",
          "'and'",
          "'or'");

  private static final int MOST_NAMED = 6;

  private SyntaxMessage() {}

  static String of(String message) {
    Matcher unexpected = UNEXPECTED.matcher(message);
    if (unexpected.matches()) {
      return "found " + found(unexpected.group(1)) + "; expected " + expected(unexpected.group(2));
    }
    Matcher missing = MISSING.matcher(message);
    if (missing.matches()) {
      return "found " + found(missing.group(2)) + "; expected " + expected(missing.group(1));
    }
    Matcher noWay = NO_WAY.matcher(message);
    if (noWay.matches()) {
      return found(noWay.group(1)) + " is not understood; expected a declaration or an expression";
    }
    Matcher noWord = NO_WORD.matcher(message);
    return noWord.matches()
        ? found(noWord.group(1)) + " is no word of the language; expected a name or an operator"
        : message;
  }

  private static String found(String text) {
    return text.replace("'<EOF>'", "the end of the file").replace("<EOF>", "").replace("\\n", " ");
  }

  private static String expected(String set) {
    List<String> all =
        Arrays.stream(set.replaceAll("^\\{|}$", "").split(", "))
            .map(each ->
                switch (each) {
                  case "ID" -> "a name";
                  case "NUMBER" -> "a number";
                  case "STRING" -> "a text in quotes";
                  case "<EOF>" -> "the end of the file";
                  default -> each;
                })
            .distinct()
            .toList();
    List<String> words = all.stream().filter(each -> !OPERATORS.contains(each)).toList();
    if (words.contains("a name") && words.size() > 1) {
      // Words that may be names are in the set, too.
      return words.contains("'if'") ? "an expression" : "a name";
    }
    if (words.contains("'automaton'")) {
      return "the next declaration or branch"; // a unit may end here, and so may its last part
    }
    List<String> named = words.isEmpty() ? all : words;
    return named.size() > MOST_NAMED ? "another word here" : String.join(" or ", named);
  }
}
