package org.starl.proof;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * Names the constants of one theory: a PVS identifier for each value, unique, and as close to the
 * value's own name as possible. {@code bot-1} is {@code bot_1}; the id {@code bot1.2.7} is {@code bot1_2_7}.
 */
final class Identifiers {

  private static final Set<String> KEYWORDS =
      new TreeSet<>(
          Arrays.asList(
              ("all and andthen array as assertion assuming assumption auto_rewrite axiom begin but by"
                      + " cases challenge claim closure codatatype coinductive cond conjecture"
                      + " containing conversion corollary datatype else elsif end endassuming"
                      + " endcases endcond endif endtable exists exporting fact false forall formula"
                      + " from function ghost has_type if iff implies importing in inductive judgement"
                      + " lambda law lemma let library macro measure nonempty_type not o obligation"
                      + " of or orelse postulate proposition recursive sublemma subtype_of subtypes"
                      + " table then theorem theory true type var when where with xor")
                  .split(" ")));

  /**
   * Names in the theories' own text: states, steps and their lemmas, bound variables, the library.
   */
  private static final Pattern OWN_NAMES =
      Pattern.compile(
          "[sa]_\\d+|(reached|step|result)_\\d+(_\\d+)?|begins|run_.*|[xi]|[A-Z]\\w*_decls|emptyset"
              + "|up|bottom|constantly|bool|nat|start|enabled|trans|states|actions|reachable");

  private final Set<String> taken = new TreeSet<>();
  private final Map<Object, String> names = new LinkedHashMap<>();

  /** The name of {@code value}; always the same. */
  String of(Object value) {
    return names.computeIfAbsent(value, this::fresh);
  }

  /** Reserves {@code name}: {@link #of} never returns it. */
  void reserve(String name) {
    taken.add(name);
  }

  /** The named values, in the order of their naming, and their names. */
  Map<Object, String> all() {
    return Collections.unmodifiableMap(names);
  }

  private String fresh(Object value) {
    String plain = plain(value.toString());
    String name = free(plain);
    for (int i = 2; taken.contains(name); i++) {
      name = free(plain + "_" + i);
    }
    taken.add(name);
    return name;
  }

  /** Names of {@link #OWN_NAMES} never begin with {@code n_}. */
  private static String free(String name) {
    boolean isReserved =
        KEYWORDS.contains(name.toLowerCase(Locale.ROOT)) || OWN_NAMES.matcher(name).matches();
    return isReserved ? "n_" + name : name;
  }

  /** {@code text} with characters that identifiers cannot have replaced. */
  static String plain(String text) {
    String plain = text.replaceAll("[^A-Za-z0-9_]", "_");
    return plain.matches("[A-Za-z].*") ? plain : "n" + plain;
  }
}
