plugins {
    id("java-platform")
    id("maven-publish")
}

description = "Versions of StarL's modules, to import"

// The modules that the pom beside this file lists.
Regex("<artifactId>(.+)</artifactId>").findAll(file("pom.xml").readText())
    .map { it.groupValues[1] }
    .filter { it != name }
    .forEach { dependencies.constraints.add("api", project(":$it")) }
