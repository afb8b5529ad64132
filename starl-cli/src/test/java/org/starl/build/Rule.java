package org.starl.build;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One thing that sources must not hold.
 *
 * @param name unique
 * @param instead what to do instead: every finding prints it
 * @param scope the files it holds for
 * @param check finds it; line numbers from 1
 * @param wrong a file that breaks the rule, so that the rule is seen to work
 */
record Rule(
    String name,
    String instead,
    Predicate<SourceFile> scope,
    Function<SourceFile, List<Integer>> check,
    SourceFile wrong) {

  /** Names no one: no tool prints it, every finding does. */
  record Finding(Rule rule, String path, int line) {
    @Override
    public String toString() {
      return path + ":" + line + ": " + rule.name + ". Instead: " + rule.instead;
    }
  }

  List<Finding> findings(SourceFile file) {
    if (!scope.test(file)) {
      return List.of();
    }
    return check.apply(file).stream().map(line -> new Finding(this, file.path(), line)).toList();
  }

  /** A pattern in the code, comments and literals apart. */
  static Function<SourceFile, List<Integer>> inCode(String regex) {
    Pattern pattern = Pattern.compile(regex);
    return file -> linesWith(pattern, file.code().lines().toList());
  }

  /** A pattern anywhere in the file. */
  static Function<SourceFile, List<Integer>> anywhere(String regex) {
    Pattern pattern = Pattern.compile(regex);
    return file -> linesWith(pattern, file.lines());
  }

  /** A pattern that may span lines, in the code, comments and literals apart. */
  static Function<SourceFile, List<Integer>> acrossLines(String regex) {
    Pattern pattern = Pattern.compile(regex);
    return file -> {
      String code = file.code();
      List<Integer> found = new ArrayList<>();
      Matcher matcher = pattern.matcher(code);
      while (matcher.find()) {
        found.add(
            1 + (int) code.substring(0, matcher.start()).chars().filter(c -> c == '\n').count());
      }
      return found;
    };
  }

  private static List<Integer> linesWith(Pattern pattern, List<String> lines) {
    List<Integer> found = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      if (pattern.matcher(lines.get(i)).find()) {
        found.add(i + 1);
      }
    }
    return found;
  }
}
