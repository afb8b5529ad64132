package org.starl.lang.java;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.JavaType;
import org.starl.lang.tree.Type;

/**
 * Which Java classes the automata that one uses have. If both give the same Java types to their common
 * types, it is the class that the used one names. Else the used one gets a class with the user's types,
 * beside the user's: of {@code GroupAutomaton} and {@code MutexAutomaton} it is {@code
 * GroupMutexAutomaton}.
 */
final class Uses {

  private Uses() {}

  /** The same automaton; what it uses, also through others, names the classes that it has for it. */
  static Automaton named(Automaton automaton) {
    Map<Type, JavaType> types = types(automaton);
    Map<String, Automaton> uses = new LinkedHashMap<>();
    automaton
        .uses()
        .forEach((component, used) ->
            uses.put(
                component,
                named(
                    fits(used, automaton, types)
                        ? used
                        : used.inJava(beside(automaton, used), merged(used, types), used.uses()))));
    return automaton.inJava(automaton.javaClass(), types, uses);
  }

  /** Those with classes beside the one of {@code named}, which are made with it. */
  static Stream<Automaton> beside(Automaton named) {
    return named.uses().values().stream()
        .filter(used -> used.javaClass().startsWith(prefix(named)))
        .flatMap(used -> Stream.concat(Stream.of(used), beside(used)));
  }

  /** All that it uses, also through others. */
  static Stream<Automaton> all(Automaton named) {
    return named.uses().values().stream()
        .flatMap(used -> Stream.concat(Stream.of(used), all(used)));
  }

  /** Those that it gives, and those of the types that it has from what it uses. */
  private static Map<Type, JavaType> types(Automaton automaton) {
    Map<Type, JavaType> types = new LinkedHashMap<>();
    automaton.javaTypes().forEach((type, java) -> types.put(type.base(), java));
    automaton.uses().values().forEach(used -> addTypes(types, types(used)));
    return types;
  }

  private static void addTypes(Map<Type, JavaType> to, Map<Type, JavaType> more) {
    more.forEach((type, java) -> {
      if (!(type instanceof Type.Opaque)) {
        to.putIfAbsent(type, java);
      }
    });
  }

  private static Map<Type, JavaType> merged(Automaton used, Map<Type, JavaType> user) {
    Map<Type, JavaType> all = new LinkedHashMap<>(user);
    addTypes(all, types(used));
    return all;
  }

  private static boolean fits(Automaton used, Automaton user, Map<Type, JavaType> users) {
    Map<Type, JavaType> own = types(used);
    return !used.javaClass().isEmpty()
        && used.typeParameters().stream()
            .map(Type.Opaque::new)
            .allMatch(each -> name(own, each).equals(name(users, each)))
        && own.keySet().stream().allMatch(each -> name(own, each).equals(name(users, each)))
        && user.javaTypes().keySet().stream()
            .map(Type::base)
            .filter(each -> !(each instanceof Type.Num || each instanceof Type.Opaque))
            .allMatch(own::containsKey);
  }

  private static Optional<String> name(Map<Type, JavaType> types, Type of) {
    return Optional.ofNullable(types.get(of)).map(JavaType::name);
  }

  private static String beside(Automaton user, Automaton used) {
    String own = used.javaClass();
    return prefix(user)
        + (own.isEmpty() ? used.name() + Names.SUFFIX : own.substring(own.lastIndexOf('.') + 1));
  }

  /** The user's class without its suffix. */
  private static String prefix(Automaton user) {
    String full = user.javaClass();
    return full.substring(0, full.length() - Names.SUFFIX.length());
  }

  /** The automata of a source that are made with those that use them, as they name no class. */
  static Set<String> unnamed(List<Automaton> automata) {
    return automata.stream()
        .filter(each -> !each.javaClass().isEmpty())
        .flatMap(Uses::all)
        .filter(each -> each.javaClass().isEmpty())
        .map(Automaton::name)
        .collect(Collectors.toSet());
  }
}
