package org.starl.lang.read;

import static java.util.Map.entry;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.Interval;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlParser;

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
          "'++'",
          "'-'",
          "'*'",
          "'/'",
          "'mod'",
          "'('",
          "'.'",
          "'..'",
          "'union'",
          "'minus'",
          "'intersect'",
          "'in'",
          "'subset'",
          "'disjoint'",
          "'is'",
          "'and'",
          "'or'");

  /** Words of other languages that are read as names before the error is seen. */
  private static final Pattern WORDS =
      Pattern.compile(
          "let|var|variables|const|constants|init|transition|rule|def|function|"
              + "choose|property|safety|liveness|require|requires|guard|effect|ensures|all|any|div");

  /** Before a name, a colon and a condition. */
  private static final Set<Integer> NAMED =
      Set.of(
          StarlParser.ASSUME, StarlParser.INVARIANT, StarlParser.CONSTRAINT, StarlParser.PROGRESS);

  private static final Set<Integer> PARTS =
      Set.of(
          StarlParser.TYPE,
          StarlParser.ASSUME,
          StarlParser.PROGRESS,
          StarlParser.STATE,
          StarlParser.USES,
          StarlParser.REFINES,
          StarlParser.FUN,
          StarlParser.START,
          StarlParser.ACTION,
          StarlParser.INVARIANT,
          StarlParser.CONSTRAINT,
          StarlParser.JAVA);

  /** From {@code type T = a} to what follows. */
  private static final int WORDS_OF_TYPE = 4;

  private static final int MOST_NAMED = 6;
  private static final String NEXT = " the next declaration or branch";

  /** What a word or sign of other languages is called here. */
  private static final Map<String, String> CURES =
      Map.ofEntries(
          entry("&", "'and'"),
          entry("|", "'or'"),
          entry("\\", "'and', 'or', 'forall', 'exists' or 'in'"),
          entry("!", "'not'"),
          entry("->", "'=>' for an implication"),
          entry("%", "'mod'"),
          entry("div", "no quotient of naturals: the language has + - * mod and, of times, /"),
          entry(";", "',' between conditions and effects, and nothing after the last one"),
          entry(",", "no ',' after the last one, or a further one behind it"),
          entry("[", "'(': the value of a map m at i is m(i)"),
          entry("{", "no braces around declarations"),
          entry("#", "'//' before a comment"),
          entry("-", "'//' before a comment, or a value before '-'"),
          entry("/", "'//' before a comment, or a value before '/'; bounds of types have no '/'"),
          entry("not", "'not' before the whole condition, as in 'not i in s', or in parentheses"),
          entry("∧", "'and'"),
          entry("∨", "'or'"),
          entry("¬", "'not'"),
          entry("∀", "'forall'"),
          entry("∃", "'exists'"),
          entry("∈", "'in'"),
          entry("≤", "'<='"),
          entry("≥", "'>='"),
          entry("let", "a function: 'fun name: type = ...'"),
          entry("var", "'state'"),
          entry("variables", "'state'"),
          entry("const", "a parameter, in [ ] after the automaton's name"),
          entry("constants", "a parameter, in [ ] after the automaton's name"),
          entry("init", "'start'"),
          entry("transition", "'action'"),
          entry("rule", "'action'"),
          entry("def", "'fun'"),
          entry("function", "'fun'"),
          entry("choose", "a variable with its type after it: 'choose x: T :: condition'"),
          entry("property", "'invariant'"),
          entry("safety", "'invariant'"),
          entry("liveness", "'progress'"),
          entry("require", "'pre'"),
          entry("requires", "'pre'"),
          entry("guard", "'pre'"),
          entry("when", "'pre' before the conditions of an action; 'when' is for locations"),
          entry("do", "'eff' before the effects of an action; 'do' is for locations"),
          entry("effect", "'eff'"),
          entry("ensures", "'eff'"),
          entry("then", "'eff' before effects, or 'if' before the condition"),
          entry("if", "',' or an operator before it"),
          entry("all", "'forall'"),
          entry("any", "'exists'"),
          entry("to", "'..' between the bounds of a range"),
          entry("end", "nothing: a declaration ends where the next one begins"));

  private SyntaxMessage() {}

  /**
   * The message of an error.
   *
   * @param at where the parser is; null if it is a lexer that reads
   */
  static String of(String message, @Nullable Token found, @Nullable Parser at) {
    if (found == null || at == null) {
      return of(message);
    }
    String cure = cure(message, found, at);
    if (cure.isEmpty()) {
      String word = previous(at, found).getText();
      boolean isName = !NO_WAY.matcher(message).matches() && WORDS.matcher(word).matches();
      cure = isName ? cureOf(word) : "";
      return cure.isEmpty() ? of(message) : "'" + word + "' is a name here; expected " + cure;
    }
    return "found '" + found.getText() + "'; expected " + cure;
  }

  private static String cure(String message, Token found, Parser at) {
    String text = found.getText();
    if (found.getType() == StarlParser.UNKNOWN && Character.isLetter(text.codePointAt(0))) {
      return "names of the letters a to z, digits and '_'";
    }
    if (found.getType() == StarlParser.UNKNOWN && text.equals("_")) {
      return "a name that begins with a letter";
    }
    Token last = at.getTokenStream().get(Math.max(0, found.getTokenIndex() - 1));
    boolean isAtOnce = last.getStopIndex() + 1 == found.getStartIndex();
    if (text.equals("=")) {
      int next = found.getStopIndex() + 1;
      CharStream chars = found.getInputStream();
      boolean isSecond = isAtOnce && last.getText().equals("=");
      if (isSecond || (next < chars.size() && chars.getText(Interval.of(next, next)).equals("="))) {
        return "one '='";
      }
    }
    if (text.equals(">") && isAtOnce && last.getText().equals("<")) {
      return "'!=' for not equal";
    }
    if (text.equals("[") && at.getContext() instanceof StarlParser.PartContext) {
      return "':' and an automaton after its name here, as in 'm: Mutex_decls[PIDS, Zones]'";
    }
    if (text.equals("in") && isInside(at, StarlParser.BinderGroupContext.class)) {
      return "':' and a type after a variable, as in 'forall i: 0..3 :: ...'";
    }
    if (NO_WAY.matcher(message).matches() && isInside(at, StarlParser.MappingContext.class)) {
      return "':=' after a component, or 'is' after an action";
    }
    String cure = cureHere(found, at);
    if (!cure.isEmpty()) {
      return cure;
    }
    boolean isEffect = isInside(at, StarlParser.EffContext.class);
    if (NO_WAY.matcher(message).matches() && isEffect) {
      return text.equals("[") ? cureOf(text) : "':=' after the place, as in 'c := c + 1'";
    }
    boolean isWord = found.getType() != StarlParser.ID && text.matches("[a-z]+");
    if (NO_WAY.matcher(message).matches() && isWord) {
      return cureOf(text).isEmpty() ? "a name, which no word of the language is" : cureOf(text);
    }
    if (found.getType() == Token.EOF || !message.contains(" expecting ")) {
      return "";
    }
    String expected = of(message);
    cure = cureOf(text);
    boolean isProgram = isInProgram(at, found);
    if (cure.isEmpty()) {
      boolean mayBeName = found.getType() == StarlParser.ID && expected.endsWith(NEXT);
      if (!mayBeName || WORDS.matcher(previous(at, found).getText()).matches()) {
        return "";
      }
      return isProgram
          ? "'when' before a guard, 'do' before statements, or " + NEXT.strip()
          : "',' before a further condition or effect, or " + NEXT.strip();
    }
    boolean isOwn = isProgram && (text.equals(";") || text.equals("when") || text.equals("do"));
    return isOwn ? "" : cure;
  }

  /** What is written otherwise where the parser is. */
  private static String cureHere(Token found, Parser at) {
    String text = found.getText();
    Token last = previous(at, found);
    Token before = previous(at, last);
    boolean isNamed = NAMED.contains(last.getType()) || NAMED.contains(before.getType());
    if (isNamed && !text.equals(":")) {
      String word = NAMED.contains(last.getType()) ? last.getText() : before.getText();
      String said = word.equals("progress") ? "n > 0 leads to n = 0" : "n > 0";
      return "a name and ':' before what is said, as in '" + word + " Some: " + said + "'";
    }
    if (text.equals(")") && last.getText().equals("(")) {
      return "no parentheses where nothing is in them";
    }
    if (text.equals(")") && isInside(at, StarlParser.BinderGroupContext.class)) {
      return "':' and a type after a name, as in '(i: PIDS)'";
    }
    boolean isComponent = at.getContext() instanceof StarlParser.ComponentContext;
    if (isComponent && !WORDS.matcher(last.getText()).matches()) {
      return "':' and a type after each component, as in 'state a: nat b: nat'";
    }
    if (text.equals(",") && isAfterComponent(at, found)) {
      return "no ',' between components, as in 'state a: nat b: nat'";
    }
    if (text.equals("(") && last.getType() == StarlParser.RECORD) {
      return "a name: declare 'type Name = record(...)', and use it here";
    }
    if ((text.equals("{") || text.equals(",")) && isInType(at, found)) {
      return "forms with '|' between them, as in 'type Color = red | green'";
    }
    if (!isInside(at, StarlParser.EffContext.class)) {
      return "";
    }
    return switch (last.getType()) {
      case StarlParser.LET -> "'let' behind ':=', as in 'c := let x = c + 1 :: x * x'";
      case StarlParser.FOR -> "all values of a map at once, as in 'm := [i: PIDS -> 0]'";
      default ->
          text.equals(":=") ? "the condition behind ':=', as in 'c := if a then 1 else c'" : "";
    };
  }

  /** Whether a declaration of a type begins some words before. */
  private static boolean isInType(Parser at, Token found) {
    Token token = found;
    for (int i = 0; i < WORDS_OF_TYPE && token.getTokenIndex() > 0; i++) {
      token = previous(at, token);
      if (token.getType() == StarlParser.TYPE) {
        return true;
      }
    }
    return false;
  }

  /** Whether the last declaration before it is 'state'. */
  private static boolean isAfterComponent(Parser at, Token found) {
    Token token = found;
    while (token.getTokenIndex() > 0 && !PARTS.contains(token.getType())) {
      token = previous(at, token);
    }
    return token.getType() == StarlParser.STATE;
  }

  private static Token previous(Parser at, Token found) {
    int index = found.getTokenIndex() - 1;
    while (index > 0 && at.getTokenStream().get(index).getChannel() != Token.DEFAULT_CHANNEL) {
      index--;
    }
    return at.getTokenStream().get(Math.max(0, index));
  }

  private static boolean isInProgram(Parser at, Token found) {
    for (int i = found.getTokenIndex(); i >= 0; i--) {
      int type = at.getTokenStream().get(i).getType();
      if (type == StarlParser.PROGRAM || type == StarlParser.AUTOMATON) {
        return type == StarlParser.PROGRAM;
      }
    }
    return false;
  }

  private static String cureOf(String word) {
    return CURES.getOrDefault(word, "");
  }

  private static boolean isInside(Parser at, Class<? extends RuleContext> rule) {
    RuleContext context = at.getContext();
    while (context != null && !rule.isInstance(context)) {
      context = context.parent;
    }
    return context != null;
  }

  private static String of(String message) {
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
      return NEXT.strip(); // a unit may end here, and so may its last part
    }
    List<String> named = words.isEmpty() ? all : words;
    return named.size() > MOST_NAMED ? "another word here" : String.join(" or ", named);
  }
}
