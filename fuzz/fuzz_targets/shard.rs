#![no_main]

durer_fuzz::target!(durer_fuzz::readers::shard);
