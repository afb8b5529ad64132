plugins {
    id("java-platform")
    id("maven-publish")
}

description = "Versions of StarL's modules, to import"

// The modules that the pom beside this file lists; its plugins are no modules.
Regex("<dependency>\\s*<groupId>.+</groupId>\\s*<artifactId>(.+)</artifactId>").findAll(file("pom.xml").readText())
    .forEach { dependencies.constraints.add("api", project(":${it.groupValues[1]}")) }
