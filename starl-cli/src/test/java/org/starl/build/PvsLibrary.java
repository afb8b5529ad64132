package org.starl.build;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The theories in {@code pvs/}, as far as their text tells without PVS. */
final class PvsLibrary {

  private static final String FOLDER = "pvs/";
  private static final String EXTENSION = ".pvs";
  private static final String TOP = "top";
  private static final Pattern COMMENT = Pattern.compile("%[^\n]*");
  private static final Pattern NAME = Pattern.compile("[A-Za-z]\\w*");

  /** What stands first on a line and before a colon, with parameters or without. */
  private static final Pattern DECLARED =
      Pattern.compile("(?m)^\\s*([A-Za-z][\\w?]*)\\s*(?:\\([^:=\n]*(?::[^:=()\n]*)*\\)\\s*)*:");

  private static final Pattern FORMULA =
      Pattern.compile(
          "([A-Za-z][\\w?]*)\\s*:\\s*(LEMMA|THEOREM|COROLLARY|PROPOSITION|CLAIM|FACT|OBLIGATION)\\b");
  private static final Pattern THEOREM =
      Pattern.compile("([A-Za-z][\\w?]*)\\s*:\\s*(?:THEOREM|COROLLARY)\\b");
  private static final Pattern DATATYPE =
      Pattern.compile("\\bactions\\s*:\\s*DATATYPE\\s+BEGIN(.*?)\\bEND\\s+actions", Pattern.DOTALL);
  private static final Pattern CONSTRUCTOR =
      Pattern.compile("(\\w+)\\s*(?:\\([^)]*\\))?\\s*:\\s*\\w+\\?");
  private static final Pattern LINK =
      Pattern.compile(
          "\\b(refinement|composition)\\s*\\[\\s*(?:(\\w+)\\.)?states\\b[^\\]]*?,\\s*(\\w+)\\.states\\b[^\\]]*]");
  private static final Pattern IMPORTING =
      Pattern.compile("IMPORTING\\s+([\\w\\s,]+?)\\s*END", Pattern.DOTALL);

  // Theories by name: their text, as it stands and without comments and proofs.
  private final SortedMap<String, String> texts = new TreeMap<>();
  private final SortedMap<String, String> bare = new TreeMap<>();

  static PvsLibrary of(Repository repository) {
    PvsLibrary library = new PvsLibrary();
    for (SourceFile file : repository.textFiles()) {
      String path = file.path();
      if (path.startsWith(FOLDER) && path.endsWith(EXTENSION)) {
        String name = path.substring(FOLDER.length(), path.length() - EXTENSION.length());
        library.texts.put(name, file.text());
        library.bare.put(name, COMMENT.matcher(file.text()).replaceAll(""));
      }
    }
    return library;
  }

  /** All but the one that only imports the others. */
  SortedSet<String> theories() {
    SortedSet<String> names = new TreeSet<>(texts.keySet());
    names.remove(TOP);
    return names;
  }

  /** What {@code pvs/check} proves. */
  SortedSet<String> imported() {
    Matcher list = IMPORTING.matcher(bare.get(TOP));
    SortedSet<String> names = new TreeSet<>();
    if (list.find()) {
      NAME.matcher(list.group(1)).results().forEach(name -> names.add(name.group()));
    }
    return names;
  }

  boolean has(String theory) {
    return texts.containsKey(theory);
  }

  /** Whether {@code theory} declares {@code name}: a formula, a predicate, a type or an action. */
  boolean declares(String theory, String name) {
    String text = bare.getOrDefault(theory, "");
    return names(DECLARED, text).contains(name) || actions(theory).contains(name);
  }

  /** The formulas that {@code theory} states. */
  Set<String> formulas(String theory) {
    return names(FORMULA, bare.get(theory));
  }

  /** Those of them that are stated for their own sake. */
  Set<String> theorems(String theory) {
    return names(THEOREM, bare.get(theory));
  }

  /** The names of the actions of the automaton that {@code theory} declares; none where it is none. */
  Set<String> actions(String theory) {
    Matcher datatype = DATATYPE.matcher(bare.getOrDefault(theory, ""));
    return datatype.find() ? names(CONSTRUCTOR, datatype.group(1)) : Set.of();
  }

  /** One automaton is proved to be another one: {@code | `A` | refines `B` | `THEORY` |}. */
  SortedSet<String> links() {
    SortedSet<String> links = new TreeSet<>();
    bare.forEach((theory, text) ->
        LINK.matcher(text)
            .results()
            .forEach(link ->
                links.add(
                    "| `%s` | %s `%s` | `%s` |"
                        .formatted(
                            link.group(2) == null ? theory : link.group(2),
                            link.group(1).equals("refinement") ? "refines" : "has as a component",
                            link.group(3),
                            theory))));
    return links;
  }

  /** The comment that {@code theory} begins with. */
  String head(String theory) {
    StringBuilder head = new StringBuilder();
    for (String line : texts.get(theory).lines().toList()) {
      if (!line.startsWith("%")) {
        break;
      }
      head.append(line.substring(1).strip()).append(' ');
    }
    return head.toString();
  }

  /** As {@code sha256sum *.pvs | sha256sum} has it, which is how {@code pvs/check} makes it. */
  String hash() {
    StringBuilder sums = new StringBuilder();
    texts.forEach((name, text) ->
        sums.append(sha256(text)).append("  ").append(name).append(EXTENSION).append('\n'));
    return sha256(sums.toString());
  }

  /** The hash of what a theory says, as in pvs/STATEMENTS: without comments, proofs, and the amount of white space. */
  String said(String theory) {
    String text = bare.getOrDefault(theory, "");
    return sha256(text.replaceAll("[ \t\n]+", " ")).substring(0, 16);
  }

  private static Set<String> names(Pattern pattern, String text) {
    Set<String> found = new TreeSet<>();
    pattern.matcher(text).results().forEach(match -> found.add(match.group(1)));
    return found;
  }

  private static String sha256(String text) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
      return HexFormat.of().formatHex(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
